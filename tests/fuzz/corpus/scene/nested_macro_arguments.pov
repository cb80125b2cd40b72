#macro Show(Look)
#declare Dull = texture { pigment { rgb <0.7, 0.3, 0.1> } finish { ambient 0.2 diffuse 0.5 } }
Show(texture { : 001;003
Show(texture { average texture_map { [1 Dull] [2 Shiny] [1 Rough] } })
Show(texture { hexagon texture { Dull } texture { Shiny } texture { Rough } scale 0.3 rotate 70*x }#end
Show(texture { gradient y texture_map { [0.2 gradient x texture_map { [0.5 Dull] [0.5 Rough] } scale 0.3] [0.8 Shiny] } }Show(texture { brick texture { Dull } texture { Rough } scale 0.1 })
