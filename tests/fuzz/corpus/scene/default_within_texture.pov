sphere { 0, 1 texture { hexagon texture { pigment { rgb x } }
#default { pigment { rgb y } } #default { pigment { rgb z } } #default { pigment { rgb 1 } }
#default { pigment { rgb y } } #default { pigment { rgb z } } #default { pigment { rgb 1 } }
} }
