<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>CostOverlay</name>
    <message>
        <source>empty space: a smaller container would save it (%1, %2)</source>
        <translation>espacio vacío: un contenedor más pequeño lo ahorraría (%1, %2)</translation>
    </message>
    <message>
        <source>finding the surface (%1, %2)</source>
        <translation>hallar la superficie (%1, %2)</translation>
    </message>
    <message>
        <source>steep field: f is flatter here than it may be elsewhere (%1, %2)</source>
        <translation>campo empinado: f es aquí más llana de lo que puede ser en otras partes (%1, %2)</translation>
    </message>
    <message>
        <source>grazing rays: along the surface (%1, %2)</source>
        <translation>rayos rasantes: a lo largo de la superficie (%1, %2)</translation>
    </message>
    <message>
        <source>singularity: f jumps, is undefined or infinitely steep (%1, %2)</source>
        <translation>singularidad: f salta, no está definida o es infinitamente empinada (%1, %2)</translation>
    </message>
    <message>
        <source>No function is evaluated in this view</source>
        <translation>En esta vista no se evalúa ninguna función</translation>
    </message>
    <message>
        <source>Evaluations of f by the rays of the camera: %1 for a pixel, at most %2</source>
        <translation>Evaluaciones de f por los rayos de la cámara: %1 por píxel, como máximo %2</translation>
    </message>
</context>
<context>
    <name>EditorKeys</name>
    <message>
        <source>To the character before</source>
        <translation>Al carácter anterior</translation>
    </message>
    <message>
        <source>To the next character</source>
        <translation>Al carácter siguiente</translation>
    </message>
    <message>
        <source>To the line above</source>
        <translation>A la línea de arriba</translation>
    </message>
    <message>
        <source>To the line below</source>
        <translation>A la línea de abajo</translation>
    </message>
    <message>
        <source>To the word before</source>
        <translation>A la palabra anterior</translation>
    </message>
    <message>
        <source>To the next word</source>
        <translation>A la palabra siguiente</translation>
    </message>
    <message>
        <source>To the beginning of the line</source>
        <translation>Al principio de la línea</translation>
    </message>
    <message>
        <source>To the end of the line</source>
        <translation>Al final de la línea</translation>
    </message>
    <message>
        <source>A page up</source>
        <translation>Una página arriba</translation>
    </message>
    <message>
        <source>A page down</source>
        <translation>Una página abajo</translation>
    </message>
    <message>
        <source>To the beginning of the text</source>
        <translation>Al principio del texto</translation>
    </message>
    <message>
        <source>To the end of the text</source>
        <translation>Al final del texto</translation>
    </message>
    <message>
        <source>Close the list of words or the help on a function</source>
        <translation>Cerrar la lista de palabras o la ayuda de una función</translation>
    </message>
    <message>
        <source>New line</source>
        <translation>Línea nueva</translation>
    </message>
    <message>
        <source>Indent, or take a word from the list</source>
        <translation>Sangrar, o tomar una palabra de la lista</translation>
    </message>
    <message>
        <source>Take indentation away</source>
        <translation>Quitar sangría</translation>
    </message>
    <message>
        <source>Delete the character before</source>
        <translation>Borrar el carácter anterior</translation>
    </message>
    <message>
        <source>Delete the next character</source>
        <translation>Borrar el carácter siguiente</translation>
    </message>
    <message>
        <source>Delete to the beginning of the word</source>
        <translation>Borrar hasta el principio de la palabra</translation>
    </message>
    <message>
        <source>Delete to the end of the word</source>
        <translation>Borrar hasta el final de la palabra</translation>
    </message>
    <message>
        <source>Number at the caret: one step up</source>
        <translation>Número en el cursor: un paso más</translation>
    </message>
    <message>
        <source>Number at the caret: one step down</source>
        <translation>Número en el cursor: un paso menos</translation>
    </message>
    <message>
        <source>Number at the caret: a tenth of a step up</source>
        <translation>Número en el cursor: una décima de paso más</translation>
    </message>
    <message>
        <source>Number at the caret: a tenth of a step down</source>
        <translation>Número en el cursor: una décima de paso menos</translation>
    </message>
    <message>
        <source>Number at the caret: ten steps up</source>
        <translation>Número en el cursor: diez pasos más</translation>
    </message>
    <message>
        <source>Number at the caret: ten steps down</source>
        <translation>Número en el cursor: diez pasos menos</translation>
    </message>
</context>
<context>
    <name>Gallery</name>
    <message>
        <source>POV-Ray&apos;s snippet: %1</source>
        <translation>Fragmento de POV-Ray: %1</translation>
    </message>
</context>
<context>
    <name>HeatOverlay</name>
    <message>
        <source>No isosurface is seen in this view</source>
        <translation>En esta vista no se ve ninguna isosuperficie</translation>
    </message>
    <message>
        <source>Gradient here: at most %1 of max_gradient</source>
        <translation>Gradiente aquí: como máximo %1 de max_gradient</translation>
    </message>
    <message>
        <source>Gradient here: up to %1 times max_gradient, over it in %2 of %3 pixels</source>
        <translation>Gradiente aquí: hasta %1 veces max_gradient, lo supera en %2 de %3 píxeles</translation>
    </message>
    <message>
        <source>|∇f| ÷ max_gradient</source>
        <translation>|∇f| ÷ max_gradient</translation>
    </message>
    <message>
        <source>over %1</source>
        <translation>más de %1</translation>
    </message>
</context>
<context>
    <name>HelpPanel</name>
    <message>
        <source>It has no parameters but the place.</source>
        <translation>No tiene más parámetros que el lugar.</translation>
    </message>
    <message>
        <source>| formula | parameter | usual value | range |</source>
        <translation>| fórmula | parámetro | valor usual | intervalo |</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>de %1 a %2</translation>
    </message>
    <message>
        <source>Formula</source>
        <translation>Fórmula</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parámetros</translation>
    </message>
    <message>
        <source>In a scene</source>
        <translation>En una escena</translation>
    </message>
    <message>
        <source>All built-in functions</source>
        <translation>Todas las funciones incorporadas</translation>
    </message>
    <message>
        <source>Numbered functions</source>
        <translation>Funciones numeradas</translation>
    </message>
    <message>
        <source>Patterns as functions</source>
        <translation>Patrones como funciones</translation>
    </message>
    <message>
        <source>Built-in functions</source>
        <translation>Funciones incorporadas</translation>
    </message>
</context>
<context>
    <name>HoleOverlay</name>
    <message>
        <source>POV-Ray&apos;s method loses none of %1 pixels</source>
        <translation>El método de POV-Ray no pierde ninguno de %1 píxeles</translation>
    </message>
    <message>
        <source>POV-Ray&apos;s method: %1 lost, %2 gained, %3 at a wrong place</source>
        <translation>Método de POV-Ray: %1 perdidos, %2 de más, %3 en lugar erróneo</translation>
    </message>
    <message>
        <source>lost: a hole in POV-Ray&apos;s picture (%1)</source>
        <translation>perdido: un hueco en la imagen de POV-Ray (%1)</translation>
    </message>
    <message>
        <source>gained: POV-Ray hits where nothing is (%1)</source>
        <translation>de más: POV-Ray acierta donde no hay nada (%1)</translation>
    </message>
    <message>
        <source>wrong place: another sheet, or off by more than accuracy explains (%1)</source>
        <translation>lugar erróneo: otra hoja, o más lejos de lo que explica accuracy (%1)</translation>
    </message>
</context>
<context>
    <name>PictureQueueWindow</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>Waits</source>
        <translation>Espera</translation>
    </message>
    <message>
        <source>Is rendered…</source>
        <translation>Se está calculando…</translation>
    </message>
    <message>
        <source>About %1 left</source>
        <translation>Faltan unos %1</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>Escrita</translation>
    </message>
    <message>
        <source>Stopped; nothing was written</source>
        <translation>Detenida; no se escribió nada</translation>
    </message>
</context>
<context>
    <name>PovrayOverlay</name>
    <message>
        <source>hole: max_gradient is too low (%1)</source>
        <translation>hueco: max_gradient es demasiado bajo (%1)</translation>
    </message>
    <message>
        <source>POV-Ray hits where nothing is (%1)</source>
        <translation>POV-Ray acierta donde no hay nada (%1)</translation>
    </message>
    <message>
        <source>another sheet: max_gradient is too low (%1)</source>
        <translation>otra hoja: max_gradient es demasiado bajo (%1)</translation>
    </message>
    <message>
        <source>other shades, by accuracy (%1)</source>
        <translation>otros tonos, por accuracy (%1)</translation>
    </message>
    <message>
        <source>the function jumps there (%1)</source>
        <translation>la función salta ahí (%1)</translation>
    </message>
    <message>
        <source>outline: a part of a pixel (%1)</source>
        <translation>contorno: parte de un píxel (%1)</translation>
    </message>
    <message>
        <source>not shown here, see Problems (%1)</source>
        <translation>no se muestra aquí, véase Problemas (%1)</translation>
    </message>
    <message>
        <source>for another reason (%1)</source>
        <translation>por otra razón (%1)</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Type a function of x, y, z in POV-Ray&apos;s language and see its surface at once.</source>
        <translation>Escriba una función de x, y, z en el lenguaje de POV-Ray y vea su superficie al instante.</translation>
    </message>
    <message>
        <source>Write a picture of the window to OUT.png as soon as everything is drawn, then end.</source>
        <translation>Escribe una imagen de la ventana en OUT.png en cuanto todo esté dibujado y termina.</translation>
    </message>
    <message>
        <source>Size of the window.</source>
        <translation>Tamaño de la ventana.</translation>
    </message>
    <message>
        <source>system, light, dark or high-contrast.</source>
        <translation>system, light, dark o high-contrast.</translation>
    </message>
    <message>
        <source>A .pov, .inc or .vl file to open.</source>
        <translation>Un archivo .pov, .inc o .vl para abrir.</translation>
    </message>
    <message>
        <source>A new scene</source>
        <translation>Una escena nueva</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
</context>
<context>
    <name>RayExplanation</name>
    <message>
        <source>%1 samples, bound %2 per unit of distance.</source>
        <translation>%1 muestras, cota %2 por unidad de distancia.</translation>
    </message>
    <message>
        <source>It dismissed the interval from %1 to %2, for it takes f to be no steeper than %3; there it is up to %4.</source>
        <translation>Descartó el intervalo de %1 a %2, pues supone que f no es más empinada que %3; ahí llega a %4.</translation>
    </message>
    <message>
        <source>Nothing is hit. </source>
        <translation>No se alcanza nada. </translation>
    </message>
    <message>
        <source>POV-Ray&apos;s method hits at %1, where nothing is. </source>
        <translation>El método de POV-Ray acierta en %1, donde no hay nada. </translation>
    </message>
    <message>
        <source>POV-Ray&apos;s method misses the surface at %1. </source>
        <translation>El método de POV-Ray no ve la superficie en %1. </translation>
    </message>
    <message>
        <source>POV-Ray&apos;s method hits at %1, where nothing is; the surface is at %2. </source>
        <translation>El método de POV-Ray acierta en %1, donde no hay nada; la superficie está en %2. </translation>
    </message>
    <message>
        <source>POV-Ray&apos;s method misses the surface at %1 and hits further back, at %2. </source>
        <translation>El método de POV-Ray no ve la superficie en %1 y acierta más atrás, en %2. </translation>
    </message>
    <message>
        <source>POV-Ray&apos;s method finds the surface at %1, off by %2. </source>
        <translation>El método de POV-Ray halla la superficie en %1, con un error de %2. </translation>
    </message>
    <message>
        <source>Yet its picture has a hole here: it dismisses rays too close to one that missed before.</source>
        <translation>Aun así, su imagen tiene un hueco aquí: descarta rayos demasiado próximos a uno que antes falló.</translation>
    </message>
</context>
<context>
    <name>ShortcutWindow</name>
    <message>
        <source>%1; with Shift: selects</source>
        <translation>%1; con Mayús: selecciona</translation>
    </message>
    <message>
        <source>In the picture</source>
        <translation>En la imagen</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Girar</translation>
    </message>
    <message>
        <source>Left drag, arrow keys</source>
        <translation>Arrastrar con el botón izquierdo, flechas</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Desplazar</translation>
    </message>
    <message>
        <source>Right or middle drag, Shift+drag, Shift+arrow keys</source>
        <translation>Arrastrar con el botón derecho o central, Mayús+arrastrar, Mayús+flechas</translation>
    </message>
    <message>
        <source>Come nearer, go away</source>
        <translation>Acercarse, alejarse</translation>
    </message>
    <message>
        <source>Wheel, + and -</source>
        <translation>Rueda, + y -</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>Mostrar todo</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>Back to the camera of the text</source>
        <translation>Volver a la cámara del texto</translation>
    </message>
    <message>
        <source>Double click, Home</source>
        <translation>Doble clic, Inicio</translation>
    </message>
    <message>
        <source>Stop the picture</source>
        <translation>Detener la imagen</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Move the divider of a split view</source>
        <translation>Mover el divisor de una vista dividida</translation>
    </message>
    <message>
        <source>Drag it, Alt+Left, Alt+Right</source>
        <translation>Arrastrarlo, Alt+Izquierda, Alt+Derecha</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menú</translation>
    </message>
    <message>
        <source>Right click, Menu</source>
        <translation>Clic derecho, Menú</translation>
    </message>
    <message>
        <source>In the text</source>
        <translation>En el texto</translation>
    </message>
    <message>
        <source>With the mouse in the text</source>
        <translation>Con el ratón en el texto</translation>
    </message>
    <message>
        <source>Change the number under the mouse</source>
        <translation>Cambiar el número bajo el ratón</translation>
    </message>
    <message>
        <source>Ctrl+drag; Alt+drag and Alt+wheel</source>
        <translation>Ctrl+arrastrar; Alt+arrastrar y Alt+rueda</translation>
    </message>
    <message>
        <source>A tenth of a step, or ten</source>
        <translation>Una décima de paso, o diez</translation>
    </message>
    <message>
        <source>Shift, or the other of Ctrl and Alt, as well</source>
        <translation>Además Mayús, o la otra de Ctrl y Alt</translation>
    </message>
    <message>
        <source>Take a drag back</source>
        <translation>Anular un arrastre</translation>
    </message>
    <message>
        <source>Esc, before the button is released</source>
        <translation>Esc, antes de soltar el botón</translation>
    </message>
    <message>
        <source>Size of the letters</source>
        <translation>Tamaño de las letras</translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation>Ctrl+rueda</translation>
    </message>
    <message>
        <source>In the panels</source>
        <translation>En los paneles</translation>
    </message>
    <message>
        <source>Parameter: back to its first value</source>
        <translation>Parámetro: volver a su primer valor</translation>
    </message>
    <message>
        <source>Double click on the name</source>
        <translation>Doble clic en el nombre</translation>
    </message>
    <message>
        <source>Parameter: another end of its range</source>
        <translation>Parámetro: otro extremo de su intervalo</translation>
    </message>
    <message>
        <source>Double click on the end</source>
        <translation>Doble clic en el extremo</translation>
    </message>
    <message>
        <source>Cross-section: shift, zoom, see all</source>
        <translation>Sección: desplazar, ampliar, ver todo</translation>
    </message>
    <message>
        <source>Drag, wheel, double click</source>
        <translation>Arrastrar, rueda, doble clic</translation>
    </message>
    <message>
        <source>Help: the page before, the next one</source>
        <translation>Ayuda: página anterior, siguiente</translation>
    </message>
    <message>
        <source>Alt+Left, Alt+Right</source>
        <translation>Alt+Izquierda, Alt+Derecha</translation>
    </message>
    <message>
        <source>Help: back to the text</source>
        <translation>Ayuda: volver al texto</translation>
    </message>
</context>
<context>
    <name>StudyPanels</name>
    <message>
        <source>The threshold does not stand in the text itself; it is not changed.</source>
        <translation>El umbral no está en el propio texto; no se cambia.</translation>
    </message>
    <message>
        <source>Cross-section</source>
        <translation>Sección</translation>
    </message>
    <message>
        <source>&lt;p&gt;The function on a plane: blue is inside the solid, orange outside, the bold line is the surface.&lt;/p&gt;</source>
        <translation>&lt;p&gt;La función en un plano: azul es el interior del sólido, naranja el exterior; la línea gruesa es la superficie.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation>Gradiente</translation>
    </message>
    <message>
        <source>&lt;p&gt;How steep the function is, and what max_gradient has to be for a picture without holes: with proof.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Lo empinada que es la función y qué max_gradient hace falta para una imagen sin huecos: con demostración.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation>Histograma</translation>
    </message>
    <message>
        <source>&lt;p&gt;How much of the container and of the surface is how steep: where a smaller max_gradient would begin to lose pixels.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Qué parte del contenedor y de la superficie tiene qué pendiente: dónde un max_gradient menor empezaría a perder píxeles.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Niveles</translation>
    </message>
    <message>
        <source>&lt;p&gt;How often the function takes which value, and the thresholds at which pieces of the surface appear, join or get tunnels: with proof.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Con qué frecuencia toma la función cada valor, y los umbrales en que aparecen piezas de la superficie, se unen o se abren túneles: con demostración.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Precisión</translation>
    </message>
    <message>
        <source>&lt;p&gt;What accuracy and max_gradient cost in time, and lose in pixels, over a range of values.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Lo que accuracy y max_gradient cuestan en tiempo y pierden en píxeles, en un intervalo de valores.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Sweep</source>
        <translation>Barrido</translation>
    </message>
    <message>
        <source>&lt;p&gt;What the values of a number cost in evaluations, how steep they make the function, and into how many pieces, tunnels and hollows: over a range of values.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Lo que los valores de un número cuestan en evaluaciones, lo empinada que hacen la función, y en cuántas piezas, túneles y cavidades: en un intervalo de valores.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Informe</translation>
    </message>
    <message>
        <source>&lt;p&gt;What the solid is like: pieces, tunnels, extent, volume, area, walls and symmetry, in sentences; and the health of the function: where it has no value, bound, slope or digits.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Cómo es el sólido: piezas, túneles, extensión, volumen, área, paredes y simetría, en frases; y la salud de la función: dónde no tiene valor, cota, pendiente o cifras.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Ray</source>
        <translation>Rayo</translation>
    </message>
    <message>
        <source>&lt;p&gt;The function along the line of sight through one pixel: where the surface is met, and what POV-Ray stepped over.&lt;/p&gt;</source>
        <translation>&lt;p&gt;La función a lo largo de la línea de visión de un píxel: dónde se encuentra la superficie y qué se saltó POV-Ray.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Effects</source>
        <translation>Efectos</translation>
    </message>
    <message>
        <source>&lt;p&gt;What the picture is made of, what each part costs, and switches for them.&lt;/p&gt;</source>
        <translation>&lt;p&gt;De qué se compone la imagen, lo que cuesta cada parte, e interruptores para ellas.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Lámina</translation>
    </message>
    <message>
        <source>&lt;p&gt;The scene in small for values of one number, or of two, as one picture; a click on one of them sets its values.&lt;/p&gt;</source>
        <translation>&lt;p&gt;La escena en pequeño para los valores de un número, o de dos, en una sola imagen; un clic en una de ellas fija sus valores.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Formula</source>
        <translation>Fórmula</translation>
    </message>
    <message>
        <source>&lt;p&gt;Quicker or more exact ways to write the function, each with its proof; and its derivatives, with a function whose gradient is 1 on the surface, as text.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Formas más rápidas o más exactas de escribir la función, cada una con su demostración; y sus derivadas, con una función cuyo gradiente es 1 en la superficie, como texto.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Evaluate</source>
        <translation>Evaluate</translation>
    </message>
    <message>
        <source>&lt;p&gt;Whether evaluate pays for an isosurface in this view, and with which numbers: measured cost and lost pixels of each.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Si evaluate compensa para una isosuperficie en esta vista, y con qué números: coste medido y píxeles perdidos de cada uno.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>Reparar</translation>
    </message>
    <message>
        <source>&lt;p&gt;Every isosurface of the scene and its include files: what its max_gradient is worth, and what it should be, with proof; one click writes what is ticked.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Cada isosuperficie de la escena y de sus archivos include: qué vale su max_gradient y cuál debería ser, con demostración; un clic escribe lo marcado.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>TimelineRow</name>
    <message>
        <source>%1 = %2 at frame %3</source>
        <translation>%1 = %2 en el fotograma %3</translation>
    </message>
    <message>
        <source>, then %1</source>
        <translation>, luego %1</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Suave</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Uniforme</translation>
    </message>
    <message>
        <source>Slow start</source>
        <translation>Comienzo lento</translation>
    </message>
    <message>
        <source>Slow end</source>
        <translation>Final lento</translation>
    </message>
    <message>
        <source>Curve through the keys</source>
        <translation>Curva por las claves</translation>
    </message>
    <message>
        <source>Hold, then jump</source>
        <translation>Mantener y saltar</translation>
    </message>
</context>
<context>
    <name>VerdictOverlay</name>
    <message>
        <source>the surface: proven</source>
        <translation>la superficie: demostrada</translation>
    </message>
    <message>
        <source>nothing there: proven</source>
        <translation>nada ahí: demostrado</translation>
    </message>
    <message>
        <source>unproven: proven but for places below accuracy/100 (a gap)</source>
        <translation>no demostrado: demostrado salvo lugares menores que accuracy/100 (un resquicio)</translation>
    </message>
    <message>
        <source>unproven: took too long, so the rest of the ray was sampled</source>
        <translation>no demostrado: tardó demasiado, así que se muestreó el resto del rayo</translation>
    </message>
    <message>
        <source>unproven: no bounds of the function are known</source>
        <translation>no demostrado: no se conocen cotas de la función</translation>
    </message>
    <message>
        <source>%1 proven</source>
        <translation>%1 demostrado</translation>
    </message>
    <message>
        <source>1 unproven pixel</source>
        <translation>1 píxel no demostrado</translation>
    </message>
    <message>
        <source>%1 unproven pixels</source>
        <translation>%1 píxeles no demostrados</translation>
    </message>
    <message>
        <source>%1  (%2)</source>
        <translation>%1  (%2)</translation>
    </message>
</context>
<context>
    <name>VerdictText</name>
    <message>
        <source>a jump</source>
        <translation>un salto</translation>
    </message>
    <message>
        <source>an infinite slope</source>
        <translation>una pendiente infinita</translation>
    </message>
    <message>
        <source>a pole</source>
        <translation>un polo</translation>
    </message>
    <message>
        <source>an overflow</source>
        <translation>un desbordamiento</translation>
    </message>
    <message>
        <source>an unknown bound</source>
        <translation>una cota desconocida</translation>
    </message>
    <message>
        <source>being proven</source>
        <translation>en demostración</translation>
    </message>
    <message>
        <source>no holes</source>
        <translation>sin huecos</translation>
    </message>
    <message>
        <source>slower than need be</source>
        <translation>más lento de lo necesario</translation>
    </message>
    <message>
        <source>infinitely steep</source>
        <translation>infinitamente empinada</translation>
    </message>
    <message>
        <source>not proven</source>
        <translation>no demostrado</translation>
    </message>
    <message>
        <source>holes</source>
        <translation>huecos</translation>
    </message>
    <message>
        <source>may have holes</source>
        <translation>puede tener huecos</translation>
    </message>
    <message>
        <source>Whether POV-Ray&apos;s picture has holes here is being found out.</source>
        <translation>Se está averiguando si la imagen de POV-Ray tiene huecos aquí.</translation>
    </message>
    <message>
        <source>POV-Ray&apos;s picture has holes: it gets %1 of this view wrong.</source>
        <translation>La imagen de POV-Ray tiene huecos: yerra en %1 de esta vista.</translation>
    </message>
    <message>
        <source>POV-Ray&apos;s picture has no holes here, from wherever you look.</source>
        <translation>La imagen de POV-Ray no tiene huecos aquí, se mire desde donde se mire.</translation>
    </message>
    <message>
        <source>POV-Ray takes %1 times as long for this view as it has to.</source>
        <translation>POV-Ray tarda %1 veces lo necesario en esta vista.</translation>
    </message>
    <message>
        <source>POV-Ray may take longer than it has to.</source>
        <translation>POV-Ray puede tardar más de lo necesario.</translation>
    </message>
    <message>
        <source>No holes in this view; other views may have some, whatever the setting.</source>
        <translation>Sin huecos en esta vista; otras pueden tenerlos con cualquier ajuste.</translation>
    </message>
    <message>
        <source>The function is infinitely steep somewhere: views may have holes.</source>
        <translation>La función es infinitamente empinada en algún lugar: puede haber vistas con huecos.</translation>
    </message>
    <message>
        <source>No holes in this view; whether others have some is not proven.</source>
        <translation>Sin huecos en esta vista; si otras los tienen no está demostrado.</translation>
    </message>
    <message>
        <source>Whether POV-Ray&apos;s picture has holes is not proven.</source>
        <translation>No está demostrado si la imagen de POV-Ray tiene huecos.</translation>
    </message>
    <message>
        <source>No holes in this view; other views may have some.</source>
        <translation>Sin huecos en esta vista; otras pueden tenerlos.</translation>
    </message>
    <message>
        <source>POV-Ray&apos;s picture may have holes.</source>
        <translation>La imagen de POV-Ray puede tener huecos.</translation>
    </message>
    <message>
        <source>max_gradient is %1, but the gradient has no bound: %2 at %3.</source>
        <translation>max_gradient es %1, pero el gradiente no tiene cota: %2 en %3.</translation>
    </message>
    <message>
        <source>max_gradient is %1, but the gradient is %2 at %3.</source>
        <translation>max_gradient es %1, pero el gradiente es %2 en %3.</translation>
    </message>
    <message>
        <source>max_gradient is %1; the function may jump somewhere.</source>
        <translation>max_gradient es %1; la función puede saltar en algún lugar.</translation>
    </message>
    <message>
        <source>max_gradient is %1; the gradient is at least %2, and nothing is known above that.</source>
        <translation>max_gradient es %1; el gradiente es al menos %2, y nada se sabe por encima.</translation>
    </message>
    <message>
        <source>max_gradient is %1; the largest gradient lies between %2 and %3.</source>
        <translation>max_gradient es %1; el gradiente máximo está entre %2 y %3.</translation>
    </message>
    <message>
        <source>max_gradient is %1; it is proven that no gradient exceeds %2.</source>
        <translation>max_gradient es %1; está demostrado que ningún gradiente supera %2.</translation>
    </message>
</context>
<context>
    <name>isoscope::AboutDialog</name>
    <message>
        <source>About Isoscope</source>
        <translation>Acerca de Isoscope</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Isoscope %1&lt;/h3&gt;&lt;p&gt;An instrument for isosurfaces: type a function of x, y, z in POV-Ray&apos;s language and see its surface at once.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later; without any warranty.&lt;/p&gt;&lt;p&gt;With Qt %2, VTK %3, QScintilla, oneTBB, Highway, SLEEF and GLM. POV-Ray is a trademark of its owner; this program contains none of its code.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Isoscope %1&lt;/h3&gt;&lt;p&gt;Un instrumento para isosuperficies: escriba una función de x, y, z en el lenguaje de POV-Ray y vea su superficie al instante.&lt;/p&gt;&lt;p&gt;Software libre bajo la Licencia Pública General de GNU, versión 3 o posterior; sin garantía alguna.&lt;/p&gt;&lt;p&gt;Con Qt %2, VTK %3, QScintilla, oneTBB, Highway, SLEEF y GLM. POV-Ray es una marca de su propietario; este programa no contiene código suyo.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>isoscope::AccuracyPanel</name>
    <message>
        <source>The setting whose values are tried</source>
        <translation>El ajuste cuyos valores se prueban</translation>
    </message>
    <message>
        <source>Setting that is studied</source>
        <translation>Ajuste estudiado</translation>
    </message>
    <message>
        <source>Measure or stop</source>
        <translation>Medir o detener</translation>
    </message>
    <message>
        <source>Progress of the measurement</source>
        <translation>Progreso de la medición</translation>
    </message>
    <message>
        <source>How much of the measurement is done</source>
        <translation>Cuánto de la medición está hecho</translation>
    </message>
    <message>
        <source>About the measurement</source>
        <translation>Sobre la medición</translation>
    </message>
    <message>
        <source>accuracy study</source>
        <translation>estudio de precisión</translation>
    </message>
    <message>
        <source>CPU seconds of the picture</source>
        <translation>Segundos de CPU de la imagen</translation>
    </message>
    <message>
        <source>Evaluations per pixel</source>
        <translation>Evaluaciones por píxel</translation>
    </message>
    <message>
        <source>What the left chart shows</source>
        <translation>Lo que muestra el gráfico izquierdo</translation>
    </message>
    <message>
        <source>Pixels missed</source>
        <translation>Píxeles perdidos</translation>
    </message>
    <message>
        <source>Pixels wrong in any way</source>
        <translation>Píxeles erróneos de algún modo</translation>
    </message>
    <message>
        <source>Worst error in t</source>
        <translation>Peor error en t</translation>
    </message>
    <message>
        <source>Mean error in t</source>
        <translation>Error medio en t</translation>
    </message>
    <message>
        <source>What the right chart shows</source>
        <translation>Lo que muestra el gráfico derecho</translation>
    </message>
    <message>
        <source>Click to write a value into the text</source>
        <translation>Clic para escribir un valor en el texto</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Measure Again</source>
        <translation>Medir de nuevo</translation>
    </message>
    <message>
        <source>End the measurement; what is measured stays</source>
        <translation>Terminar la medición; lo medido se queda</translation>
    </message>
    <message>
        <source>Render the view with nine values, three times each</source>
        <translation>Calcular la vista con nueve valores, tres veces cada uno</translation>
    </message>
    <message>
        <source>It is measured as soon as nothing moves.</source>
        <translation>Se mide en cuanto nada se mueve.</translation>
    </message>
    <message>
        <source>The scene has no isosurface to measure.</source>
        <translation>La escena no tiene isosuperficie que medir.</translation>
    </message>
    <message>
        <source>POV-Ray</source>
        <translation>POV-Ray</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>exacto</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>ahora %1</translation>
    </message>
    <message>
        <source>Chart over %1</source>
        <translation>Gráfico sobre %1</translation>
    </message>
    <message>
        <source>Choosing the size of the picture…</source>
        <translation>Eligiendo el tamaño de la imagen…</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 píxeles</translation>
    </message>
    <message>
        <source>Measured before the last change of scene or view.</source>
        <translation>Medido antes del último cambio de escena o vista.</translation>
    </message>
    <message>
        <source>%1; stopped early.</source>
        <translation>%1; detenido antes de tiempo.</translation>
    </message>
    <message>
        <source>%1, median of 3 runs</source>
        <translation>%1, mediana de 3 pasadas</translation>
    </message>
    <message>
        <source>Click for %1 %2.</source>
        <translation>Clic para %1 %2.</translation>
    </message>
</context>
<context>
    <name>isoscope::Actions</name>
    <message>
        <source>Inc&amp;lude Folders…</source>
        <translation>Carpetas de inclusión…</translation>
    </message>
    <message>
        <source>Where #include looks besides the folder of the file</source>
        <translation>Dónde busca #include además de la carpeta del archivo</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;yuda</translation>
    </message>
    <message>
        <source>Open the page about the word at the caret, or about the panel with the focus</source>
        <translation>Abrir la página sobre la palabra en el cursor o sobre el panel con el foco</translation>
    </message>
    <message>
        <source>&amp;Lessons</source>
        <translation>&amp;Lecciones</translation>
    </message>
    <message>
        <source>Open the list of short lessons about isosurfaces</source>
        <translation>Abrir la lista de lecciones breves sobre isosuperficies</translation>
    </message>
    <message>
        <source>&amp;Commands…</source>
        <translation>&amp;Comandos…</translation>
    </message>
    <message>
        <source>Find a command of the menus by words and run it</source>
        <translation>Buscar un comando de los menús por palabras y ejecutarlo</translation>
    </message>
    <message>
        <source>&amp;Keyboard Shortcuts</source>
        <translation>Atajos de &amp;teclado</translation>
    </message>
    <message>
        <source>All commands and their keys</source>
        <translation>Todos los comandos y sus teclas</translation>
    </message>
    <message>
        <source>&amp;What Is This?</source>
        <translation>¿&amp;Qué es esto?</translation>
    </message>
    <message>
        <source>Click anything of the window to hear what it is</source>
        <translation>Pulse cualquier cosa de la ventana para saber qué es</translation>
    </message>
    <message>
        <source>&amp;About Isoscope</source>
        <translation>Acerca &amp;de Isoscope</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>Versión y licencia</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nuevo</translation>
    </message>
    <message>
        <source>Start with an empty scene</source>
        <translation>Empezar con una escena vacía</translation>
    </message>
    <message>
        <source>New &amp;Window</source>
        <translation>Nueva &amp;ventana</translation>
    </message>
    <message>
        <source>Open another window with a document of its own</source>
        <translation>Abrir otra ventana con un documento propio</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>A&amp;brir…</translation>
    </message>
    <message>
        <source>Open a scene or include file</source>
        <translation>Abrir una escena o un archivo de inclusión</translation>
    </message>
    <message>
        <source>Start Pa&amp;ge</source>
        <translation>&amp;Página de inicio</translation>
    </message>
    <message>
        <source>Choose a scene to begin with, by its picture</source>
        <translation>Elegir por su imagen una escena para empezar</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>Save the text</source>
        <translation>Guardar el texto</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Guardar &amp;como…</translation>
    </message>
    <message>
        <source>Save the text under another name</source>
        <translation>Guardar el texto con otro nombre</translation>
    </message>
    <message>
        <source>&amp;Kept Texts…</source>
        <translation>Textos conserva&amp;dos…</translation>
    </message>
    <message>
        <source>List the texts that were kept because they were not saved</source>
        <translation>Lista de los textos conservados por no haberse guardado</translation>
    </message>
    <message>
        <source>Fo&amp;llow Another Editor</source>
        <translation>Seguir o&amp;tro editor</translation>
    </message>
    <message>
        <source>Take over what another program saves to the file, while the text has no changes here</source>
        <translation>Tomar lo que otro programa guarda en el archivo mientras el texto no tenga cambios aquí</translation>
    </message>
    <message>
        <source>Copy &amp;Isosurface</source>
        <translation>Copiar &amp;isosuperficie</translation>
    </message>
    <message>
        <source>Copy the isosurface at the caret, with the declarations it needs</source>
        <translation>Copiar la isosuperficie en el cursor, con las declaraciones que necesita</translation>
    </message>
    <message>
        <source>Cop&amp;y Picture</source>
        <translation>Copiar im&amp;agen</translation>
    </message>
    <message>
        <source>Copy the picture as it is shown; Ctrl and the mouse drag it out of the window</source>
        <translation>Copiar la imagen tal como se muestra; con Ctrl y el ratón se arrastra fuera de la ventana</translation>
    </message>
    <message>
        <source>Copy &amp;Difference Surface</source>
        <translation>Copiar superficie de &amp;diferencia</translation>
    </message>
    <message>
        <source>Copy the isosurface that is 0 where the kept function and the present one agree (View, Overlay, Compare A/B)</source>
        <translation>Copiar la isosuperficie que es 0 donde la función conservada y la actual coinciden (Ver, Superposición, Comparar A/B)</translation>
    </message>
    <message>
        <source>Isosurface as Include &amp;File…</source>
        <translation>Isosuperficie como archivo in&amp;clude…</translation>
    </message>
    <message>
        <source>Write the isosurface at the caret, with the declarations it needs, to an .inc file</source>
        <translation>Escribir la isosuperficie en el cursor, con las declaraciones que necesita, en un archivo .inc</translation>
    </message>
    <message>
        <source>Complete &amp;Scene for POV-Ray…</source>
        <translation>&amp;Escena completa para POV-Ray…</translation>
    </message>
    <message>
        <source>Write a .pov file that POV-Ray renders to the picture of the viewport</source>
        <translation>Escribir un archivo .pov con el que POV-Ray calcula la imagen del visor</translation>
    </message>
    <message>
        <source>Objects for &amp;VirtuaLight…</source>
        <translation>Objetos para &amp;VirtuaLight…</translation>
    </message>
    <message>
        <source>Write a .vl file of the objects that VirtuaLight&apos;s notation can say</source>
        <translation>Escribir un archivo .vl con los objetos que la notación de VirtuaLight puede expresar</translation>
    </message>
    <message>
        <source>I&amp;mage…</source>
        <translation>I&amp;magen…</translation>
    </message>
    <message>
        <source>Render the view to a PNG or OpenEXR file of any size</source>
        <translation>Calcular la vista en un archivo PNG u OpenEXR de cualquier tamaño</translation>
    </message>
    <message>
        <source>Pictures in the Ma&amp;king…</source>
        <translation>Imá&amp;genes en curso…</translation>
    </message>
    <message>
        <source>List the images that are being rendered, and stop them</source>
        <translation>Lista de las imágenes que se calculan, para detenerlas</translation>
    </message>
    <message>
        <source>&amp;Animation for POV-Ray…</source>
        <translation>Animación para &amp;POV-Ray…</translation>
    </message>
    <message>
        <source>Write a .pov file whose numbers follow clock as the timeline has them, and its .ini file</source>
        <translation>Escribir un archivo .pov cuyos números siguen a clock como en la línea de tiempo, y su archivo .ini</translation>
    </message>
    <message>
        <source>F&amp;rames and Film…</source>
        <translation>&amp;Fotogramas y película…</translation>
    </message>
    <message>
        <source>Draw the frames of the timeline into pictures, and a film where ffmpeg is installed</source>
        <translation>Dibujar los fotogramas de la línea de tiempo en imágenes, y una película si ffmpeg está instalado</translation>
    </message>
    <message>
        <source>M&amp;esh…</source>
        <translation>Ma&amp;lla…</translation>
    </message>
    <message>
        <source>Write the isosurfaces as triangles: STL, 3MF, OBJ, PLY, glTF, or for POV-Ray</source>
        <translation>Escribir las isosuperficies como triángulos: STL, 3MF, OBJ, PLY, glTF, o para POV-Ray</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Salir</translation>
    </message>
    <message>
        <source>Close the window; unsaved text is kept for the next start</source>
        <translation>Cerrar la ventana; el texto sin guardar se conserva para el próximo inicio</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>Take back the last change; a drag of a slider is one change</source>
        <translation>Anular el último cambio; un arrastre de un deslizador es un cambio</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>Do again what was taken back</source>
        <translation>Hacer de nuevo lo que se anuló</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Cor&amp;tar</translation>
    </message>
    <message>
        <source>Move the selected text to the clipboard</source>
        <translation>Mover el texto seleccionado al portapapeles</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copiar</translation>
    </message>
    <message>
        <source>Copy the selected text to the clipboard</source>
        <translation>Copiar el texto seleccionado al portapapeles</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Pegar</translation>
    </message>
    <message>
        <source>Insert the text of the clipboard</source>
        <translation>Insertar el texto del portapapeles</translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation>&amp;Seleccionar todo</translation>
    </message>
    <message>
        <source>Select the whole text</source>
        <translation>Seleccionar el texto entero</translation>
    </message>
    <message>
        <source>&amp;Find…</source>
        <translation>&amp;Buscar…</translation>
    </message>
    <message>
        <source>Find in the text</source>
        <translation>Buscar en el texto</translation>
    </message>
    <message>
        <source>Find and R&amp;eplace…</source>
        <translation>Buscar y r&amp;eemplazar…</translation>
    </message>
    <message>
        <source>Find and replace in the text</source>
        <translation>Buscar y reemplazar en el texto</translation>
    </message>
    <message>
        <source>Find &amp;Next</source>
        <translation>Buscar s&amp;iguiente</translation>
    </message>
    <message>
        <source>Go to the next match</source>
        <translation>Ir a la siguiente coincidencia</translation>
    </message>
    <message>
        <source>Find Pre&amp;vious</source>
        <translation>Buscar a&amp;nterior</translation>
    </message>
    <message>
        <source>Go to the match before</source>
        <translation>Ir a la coincidencia anterior</translation>
    </message>
    <message>
        <source>To&amp;ggle Comment</source>
        <translation>Poner o &amp;quitar comentario</translation>
    </message>
    <message>
        <source>Turn the selected lines into comments, or back</source>
        <translation>Convertir las líneas seleccionadas en comentarios, o al revés</translation>
    </message>
    <message>
        <source>Ad&amp;just Number…</source>
        <translation>A&amp;justar número…</translation>
    </message>
    <message>
        <source>Open a slider for the number at the caret</source>
        <translation>Abrir un deslizador para el número en el cursor</translation>
    </message>
    <message>
        <source>F&amp;it Container</source>
        <translation>Ajustar c&amp;ontenedor</translation>
    </message>
    <message>
        <source>Give the isosurface at the caret the smallest container that is proven to show the same; POV-Ray looks for roots only inside</source>
        <translation>Dar a la isosuperficie en el cursor el contenedor más pequeño que demostradamente muestra lo mismo; POV-Ray solo busca raíces dentro</translation>
    </message>
    <message>
        <source>&amp;Function…</source>
        <translation>&amp;Función…</translation>
    </message>
    <message>
        <source>Search the built-in functions and insert one</source>
        <translation>Buscar en las funciones incorporadas e insertar una</translation>
    </message>
    <message>
        <source>&amp;Fit View</source>
        <translation>&amp;Encuadrar todo</translation>
    </message>
    <message>
        <source>Show everything that is there, whole; F alone does it in the picture</source>
        <translation>Mostrar entero todo lo que hay; en la imagen basta F</translation>
    </message>
    <message>
        <source>From the F&amp;ront</source>
        <translation>Desde el &amp;frente</translation>
    </message>
    <message>
        <source>Look at everything from the front</source>
        <translation>Mirar todo desde el frente</translation>
    </message>
    <message>
        <source>From A&amp;bove</source>
        <translation>Desde a&amp;rriba</translation>
    </message>
    <message>
        <source>Look at everything from above</source>
        <translation>Mirar todo desde arriba</translation>
    </message>
    <message>
        <source>From the Rig&amp;ht</source>
        <translation>Desde la &amp;derecha</translation>
    </message>
    <message>
        <source>Look at everything from the right side</source>
        <translation>Mirar todo desde el lado derecho</translation>
    </message>
    <message>
        <source>&amp;As the Text Says</source>
        <translation>&amp;Como dice el texto</translation>
    </message>
    <message>
        <source>Go back to the camera of the text</source>
        <translation>Volver a la cámara del texto</translation>
    </message>
    <message>
        <source>&amp;Write View into Text</source>
        <translation>Escribir la &amp;vista en el texto</translation>
    </message>
    <message>
        <source>Make the present view the camera block of the text</source>
        <translation>Hacer de la vista actual el bloque camera del texto</translation>
    </message>
    <message>
        <source>Re&amp;draw</source>
        <translation>Redi&amp;bujar</translation>
    </message>
    <message>
        <source>Render the picture again</source>
        <translation>Calcular la imagen de nuevo</translation>
    </message>
    <message>
        <source>Update W&amp;hile Typing</source>
        <translation>&amp;Actualizar al escribir</translation>
    </message>
    <message>
        <source>Show what is typed after a moment; else when it is saved, or on Redraw</source>
        <translation>Mostrar lo escrito tras un momento; si no, al guardar o con Redibujar</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Detener</translation>
    </message>
    <message>
        <source>Stop the picture in the making</source>
        <translation>Detener la imagen en curso</translation>
    </message>
    <message>
        <source>S&amp;mooth Edges</source>
        <translation>Bordes s&amp;uaves</translation>
    </message>
    <message>
        <source>Render the resting picture with anti-aliasing; takes longer</source>
        <translation>Calcular la imagen en reposo con suavizado de bordes; tarda más</translation>
    </message>
    <message>
        <source>E&amp;xact</source>
        <translation>E&amp;xacto</translation>
    </message>
    <message>
        <source>Show the surface as it is, without holes; the certified root finder proves it</source>
        <translation>Mostrar la superficie tal como es, sin huecos; el buscador de raíces certificado lo demuestra</translation>
    </message>
    <message>
        <source>As PO&amp;V-Ray</source>
        <translation>Como &amp;POV-Ray</translation>
    </message>
    <message>
        <source>Show what POV-Ray will draw, holes included, with the text&apos;s max_gradient and accuracy</source>
        <translation>Mostrar lo que POV-Ray dibujará, con sus huecos, con max_gradient y accuracy del texto</translation>
    </message>
    <message>
        <source>Containe&amp;r Outlines</source>
        <translation>C&amp;ontornos de contenedores</translation>
    </message>
    <message>
        <source>Draw the containers of the isosurfaces over the picture</source>
        <translation>Dibujar los contenedores de las isosuperficies sobre la imagen</translation>
    </message>
    <message>
        <source>Container</source>
        <translation>Contenedor</translation>
    </message>
    <message>
        <source>Ax&amp;es</source>
        <translation>E&amp;jes</translation>
    </message>
    <message>
        <source>Draw the axes of the scene, and how the view is turned</source>
        <translation>Dibujar los ejes de la escena y cómo está girada la vista</translation>
    </message>
    <message>
        <source>&amp;Cut Faces</source>
        <translation>Caras co&amp;rtadas</translation>
    </message>
    <message>
        <source>Hatch where a container cuts its isosurface; that face is no surface of the function</source>
        <translation>Rayar donde un contenedor corta su isosuperficie; esa cara no es superficie de la función</translation>
    </message>
    <message>
        <source>Show &amp;Unproven Pixels</source>
        <translation>Píxeles &amp;no demostrados</translation>
    </message>
    <message>
        <source>Mark the pixels of the exact picture that are not proven to be right</source>
        <translation>Marcar los píxeles de la imagen exacta cuya corrección no está demostrada</translation>
    </message>
    <message>
        <source>Unproven</source>
        <translation>Dudosos</translation>
    </message>
    <message>
        <source>&amp;System</source>
        <translation>&amp;Sistema</translation>
    </message>
    <message>
        <source>Light or dark as the desktop is</source>
        <translation>Claro u oscuro, como el escritorio</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Claro</translation>
    </message>
    <message>
        <source>Light colours</source>
        <translation>Colores claros</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Oscuro</translation>
    </message>
    <message>
        <source>Dark colours</source>
        <translation>Colores oscuros</translation>
    </message>
    <message>
        <source>High &amp;Contrast</source>
        <translation>&amp;Alto contraste</translation>
    </message>
    <message>
        <source>White on black, with outlines; text of at least 7:1</source>
        <translation>Blanco sobre negro, con contornos; textos de al menos 7:1</translation>
    </message>
    <message>
        <source>Wrap Lon&amp;g Lines</source>
        <translation>Partir líneas largas</translation>
    </message>
    <message>
        <source>Continue lines of the text that are too long for its panel on the next row</source>
        <translation>Continuar en la fila siguiente las líneas del texto demasiado largas para su panel</translation>
    </message>
    <message>
        <source>&amp;Browse Gallery</source>
        <translation>Explorar la &amp;galería</translation>
    </message>
    <message>
        <source>Choose among functions, examples and your own scenes, with pictures</source>
        <translation>Elegir entre funciones, ejemplos y escenas propias, con imágenes</translation>
    </message>
    <message>
        <source>Ne&amp;xt Panel</source>
        <translation>Panel &amp;siguiente</translation>
    </message>
    <message>
        <source>Go to the next of panels, picture and tool bars</source>
        <translation>Ir al siguiente de paneles, imagen y barras de herramientas</translation>
    </message>
    <message>
        <source>Pre&amp;vious Panel</source>
        <translation>Panel &amp;anterior</translation>
    </message>
    <message>
        <source>Go to the one before of panels, picture and tool bars</source>
        <translation>Ir al anterior de paneles, imagen y barras de herramientas</translation>
    </message>
    <message>
        <source>Reset La&amp;yout</source>
        <translation>Restablecer disposición</translation>
    </message>
    <message>
        <source>Put all panels back to their places</source>
        <translation>Devolver todos los paneles a su lugar</translation>
    </message>
    <message>
        <source>&amp;Larger</source>
        <translation>&amp;Mayor</translation>
    </message>
    <message>
        <source>Larger letters in the text</source>
        <translation>Letras más grandes en el texto</translation>
    </message>
    <message>
        <source>&amp;Smaller</source>
        <translation>M&amp;enor</translation>
    </message>
    <message>
        <source>Smaller letters in the text</source>
        <translation>Letras más pequeñas en el texto</translation>
    </message>
    <message>
        <source>&amp;Normal</source>
        <translation>&amp;Normal</translation>
    </message>
    <message>
        <source>Letters of the usual size</source>
        <translation>Letras del tamaño usual</translation>
    </message>
    <message>
        <source>Everything at %1 %</source>
        <translation>Todo al %1 %</translation>
    </message>
    <message>
        <source>Letters, icons and marks of the whole window at %1 % of the desktop&apos;s size</source>
        <translation>Letras, iconos y marcas de toda la ventana al %1 % del tamaño del escritorio</translation>
    </message>
    <message>
        <source>Texts of the window in this language, from the next start on</source>
        <translation>Textos de la ventana en este idioma, desde el próximo inicio</translation>
    </message>
    <message>
        <source>&amp;The System&apos;s Language</source>
        <translation>El idioma del &amp;sistema</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Ninguna</translation>
    </message>
    <message>
        <source>Show the picture alone</source>
        <translation>Mostrar solo la imagen</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Superposición</translation>
    </message>
    <message>
        <source>&amp;Holes</source>
        <translation>&amp;Huecos</translation>
    </message>
    <message>
        <source>Mark the holes of POV-Ray&apos;s picture: pixels lost, gained or found at a wrong place</source>
        <translation>Marcar los huecos de la imagen de POV-Ray: píxeles perdidos, de más o en lugar erróneo</translation>
    </message>
    <message>
        <source>S&amp;plit View</source>
        <translation>Vista &amp;dividida</translation>
    </message>
    <message>
        <source>POV-Ray&apos;s picture left of a divider, the exact one right of it</source>
        <translation>La imagen de POV-Ray a la izquierda de un divisor, la exacta a la derecha</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Dividida</translation>
    </message>
    <message>
        <source>&amp;Difference Only</source>
        <translation>&amp;Solo diferencia</translation>
    </message>
    <message>
        <source>What POV-Ray&apos;s picture gets wrong, without the picture</source>
        <translation>Lo que la imagen de POV-Ray tiene mal, sin la imagen</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Diferencia</translation>
    </message>
    <message>
        <source>&amp;Gradient</source>
        <translation>&amp;Gradiente</translation>
    </message>
    <message>
        <source>How steep the function is on the surface, as a share of max_gradient</source>
        <translation>Lo empinada que es la función en la superficie, como parte de max_gradient</translation>
    </message>
    <message>
        <source>&amp;Beside POV-Ray Itself</source>
        <translation>&amp;Junto al propio POV-Ray</translation>
    </message>
    <message>
        <source>Have the installed POV-Ray draw the text: its picture left of a divider, the exact one right</source>
        <translation>El POV-Ray instalado dibuja el texto: su imagen a la izquierda de un divisor, la exacta a la derecha</translation>
    </message>
    <message>
        <source>POV-Ray</source>
        <translation>POV-Ray</translation>
    </message>
    <message>
        <source>Difference &amp;from POV-Ray Itself</source>
        <translation>Diferencia con el propio &amp;POV-Ray</translation>
    </message>
    <message>
        <source>Have the installed POV-Ray draw the text, and mark what differs, by cause</source>
        <translation>El POV-Ray instalado dibuja el texto, y se marca lo que difiere, por causas</translation>
    </message>
    <message>
        <source>Differs</source>
        <translation>Difiere</translation>
    </message>
    <message>
        <source>&amp;Compare A/B</source>
        <translation>&amp;Comparar A/B</translation>
    </message>
    <message>
        <source>Keep the scene as it is now, and show it left of a divider while you change it</source>
        <translation>Conservar la escena como está ahora y mostrarla a la izquierda de un divisor mientras la cambia</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparar</translation>
    </message>
    <message>
        <source>&amp;Inspect Ray</source>
        <translation>Inspeccionar ra&amp;yo</translation>
    </message>
    <message>
        <source>Click a pixel to see the function along its ray in the panel “Ray”</source>
        <translation>Pulse un píxel para ver la función a lo largo de su rayo en el panel «Rayo»</translation>
    </message>
    <message>
        <source>Ray</source>
        <translation>Rayo</translation>
    </message>
    <message>
        <source>Section &amp;Plane</source>
        <translation>Plano de secc&amp;ión</translation>
    </message>
    <message>
        <source>Show the plane of the cross-section in the picture; its square moves it, the ball turns it</source>
        <translation>Mostrar el plano de la sección en la imagen; su cuadrado lo mueve, la bola lo gira</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Plano</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Abrir &amp;reciente</translation>
    </message>
    <message>
        <source>Open E&amp;xample</source>
        <translation>Abrir e&amp;jemplo</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exportar</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Editar</translation>
    </message>
    <message>
        <source>&amp;Insert</source>
        <translation>&amp;Insertar</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>Loo&amp;k</source>
        <translation>&amp;Mirar</translation>
    </message>
    <message>
        <source>&amp;Overlay</source>
        <translation>&amp;Superposición</translation>
    </message>
    <message>
        <source>Pa&amp;nels</source>
        <translation>Pane&amp;les</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Tema</translation>
    </message>
    <message>
        <source>Text Si&amp;ze</source>
        <translation>Tamaño de &amp;fuente</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>Show:</source>
        <translation>Mostrar:</translation>
    </message>
    <message>
        <source>C&amp;ost</source>
        <translation>Cos&amp;te</translation>
    </message>
    <message>
        <source>What each pixel takes in evaluations of the function, in the colour of its cause</source>
        <translation>Lo que requiere cada píxel en evaluaciones de la función, en el color de su causa</translation>
    </message>
    <message>
        <source>&amp;Comment of What Is Proven</source>
        <translation>C&amp;omentario de lo demostrado</translation>
    </message>
    <message>
        <source>Put a comment in front of isosurfaces that states the proven bound, method, view and version; it is checked when the text is opened again</source>
        <translation>Poner delante de las isosuperficies un comentario con la cota demostrada, el método, la vista y la versión; se comprueba al volver a abrir el texto</translation>
    </message>
</context>
<context>
    <name>isoscope::AnimationExportDialog</name>
    <message>
        <source>Frames and film</source>
        <translation>Fotogramas y película</translation>
    </message>
    <message>
        <source>ffmpeg cannot be started.</source>
        <translation>No se puede iniciar ffmpeg.</translation>
    </message>
    <message>
        <source>ffmpeg made no film: %1</source>
        <translation>ffmpeg no hizo la película: %1</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Width of the frames</source>
        <translation>Anchura de los fotogramas</translation>
    </message>
    <message>
        <source>Height of the frames</source>
        <translation>Altura de los fotogramas</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Smooth edges (anti-aliasing)</source>
        <translation>Bordes suaves (suavizado)</translation>
    </message>
    <message>
        <source>Several rays for pixels on edges; takes longer</source>
        <translation>Varios rayos para los píxeles de los bordes; tarda más</translation>
    </message>
    <message>
        <source>How the names of the pictures begin</source>
        <translation>Cómo empiezan los nombres de las imágenes</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Carpeta…</translation>
    </message>
    <message>
        <source>Choose the folder of the pictures</source>
        <translation>Elegir la carpeta de las imágenes</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Archivos</translation>
    </message>
    <message>
        <source>The number of the frame and .png follow</source>
        <translation>Siguen el número del fotograma y .png</translation>
    </message>
    <message>
        <source>Make a film of them, %1 frames per second</source>
        <translation>Hacer con ellos una película, %1 fotogramas por segundo</translation>
    </message>
    <message>
        <source>An .mp4 file beside the pictures, made by ffmpeg</source>
        <translation>Un archivo .mp4 junto a las imágenes, hecho por ffmpeg</translation>
    </message>
    <message>
        <source>ffmpeg is not installed</source>
        <translation>ffmpeg no está instalado</translation>
    </message>
    <message>
        <source> (ffmpeg is not installed)</source>
        <translation> (ffmpeg no está instalado)</translation>
    </message>
    <message>
        <source>%v of %m frames</source>
        <translation>%v de %m fotogramas</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Dibujar</translation>
    </message>
    <message>
        <source>Draw all frames and write them</source>
        <translation>Dibujar todos los fotogramas y escribirlos</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Stop; frames that are written stay</source>
        <translation>Detener; los fotogramas escritos se quedan</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close; drawing is stopped</source>
        <translation>Cerrar; se detiene el dibujo</translation>
    </message>
    <message>
        <source>Folder of the pictures</source>
        <translation>Carpeta de las imágenes</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
    </message>
    <message>
        <source>There are frames with such names already. Replace them?</source>
        <translation>Ya hay fotogramas con esos nombres. ¿Reemplazarlos?</translation>
    </message>
    <message>
        <source>Please choose how the names begin.</source>
        <translation>Elija cómo empiezan los nombres.</translation>
    </message>
    <message>
        <source>That is more than %1 million pixels.</source>
        <translation>Eso es más de %1 millones de píxeles.</translation>
    </message>
    <message>
        <source>%1 is no PNG picture: it is not replaced.</source>
        <translation>%1 no es una imagen PNG: no se reemplaza.</translation>
    </message>
    <message>
        <source>%1 cannot be made.</source>
        <translation>No se puede crear %1.</translation>
    </message>
    <message>
        <source>Drawing…</source>
        <translation>Dibujando…</translation>
    </message>
    <message>
        <source>Making the film…</source>
        <translation>Haciendo la película…</translation>
    </message>
    <message>
        <source>film: %v of %m frames</source>
        <translation>película: %v de %m fotogramas</translation>
    </message>
    <message>
        <source>Stopped; the frames that are written stay.</source>
        <translation>Detenido; los fotogramas escritos se quedan.</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Escrito: %1</translation>
    </message>
</context>
<context>
    <name>isoscope::ChartSaver</name>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Write the chart, or its numbers, to a file</source>
        <translation>Escribir el gráfico, o sus números, en un archivo</translation>
    </message>
    <message>
        <source>Save the chart or its numbers</source>
        <translation>Guardar el gráfico o sus números</translation>
    </message>
    <message>
        <source>Chart as &amp;SVG…</source>
        <translation>Gráfico como &amp;SVG…</translation>
    </message>
    <message>
        <source>SVG drawings (*.svg)</source>
        <translation>Dibujos SVG (*.svg)</translation>
    </message>
    <message>
        <source>Chart as &amp;PNG…</source>
        <translation>Gráfico como &amp;PNG…</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>Imágenes PNG (*.png)</translation>
    </message>
    <message>
        <source>&amp;Numbers (CSV)…</source>
        <translation>&amp;Números (CSV)…</translation>
    </message>
    <message>
        <source>CSV tables (*.csv)</source>
        <translation>Tablas CSV (*.csv)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Guardado: %1.</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>No se puede escribir %1.</translation>
    </message>
</context>
<context>
    <name>isoscope::CommandKeys</name>
    <message>
        <source>A command has one combination of keys, not several in a row.</source>
        <translation>Un comando tiene una combinación de teclas, no varias seguidas.</translation>
    </message>
    <message>
        <source>These keys belong to the text: %1.</source>
        <translation>Estas teclas pertenecen al texto: %1.</translation>
    </message>
    <message>
        <source>A letter alone is text; add Ctrl or Alt.</source>
        <translation>Una letra sola es texto; añada Ctrl o Alt.</translation>
    </message>
</context>
<context>
    <name>isoscope::CommandPalette</name>
    <message>
        <source>Commands</source>
        <translation>Comandos</translation>
    </message>
    <message>
        <source>&lt;p&gt;Every command of the menus. Type words of its name, or of what it tells of itself, and press Enter.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Todos los comandos de los menús. Escriba palabras de su nombre, o de lo que cuenta de sí mismo, y pulse Intro.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Type a command, then Enter</source>
        <translation>Escriba un comando y pulse Intro</translation>
    </message>
    <message>
        <source>Words of a command</source>
        <translation>Palabras de un comando</translation>
    </message>
    <message>
        <source>Lists the commands that these words name</source>
        <translation>Muestra los comandos que nombran estas palabras</translation>
    </message>
    <message>
        <source>Commands with their keys</source>
        <translation>Comandos con sus teclas</translation>
    </message>
    <message>
        <source>The commands of the menus</source>
        <translation>Los comandos de los menús</translation>
    </message>
</context>
<context>
    <name>isoscope::ContainerFitter</name>
    <message>
        <source>Looking for the smallest container that is proven to show the same…</source>
        <translation>Buscando el contenedor más pequeño que demostradamente muestra lo mismo…</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Detener</translation>
    </message>
    <message>
        <source>Leaves the container as it is</source>
        <translation>Deja el contenedor como está</translation>
    </message>
    <message>
        <source>The text is still being read.</source>
        <translation>El texto aún se está leyendo.</translation>
    </message>
    <message>
        <source>There is no isosurface in the text.</source>
        <translation>No hay isosuperficie en el texto.</translation>
    </message>
    <message>
        <source>Looking for the smallest container…</source>
        <translation>Buscando el contenedor más pequeño…</translation>
    </message>
    <message>
        <source>Stopped; the container is left alone.</source>
        <translation>Detenido; el contenedor no se toca.</translation>
    </message>
    <message>
        <source>The text has changed; its container is left alone.</source>
        <translation>El texto ha cambiado; su contenedor no se toca.</translation>
    </message>
    <message>
        <source>Nothing of this isosurface is in its container.</source>
        <translation>Nada de esta isosuperficie está en su contenedor.</translation>
    </message>
    <message>
        <source>No container is proven to show the same with less room.</source>
        <translation>Ningún contenedor más pequeño muestra demostradamente lo mismo.</translation>
    </message>
    <message>
        <source>The isosurface does not stand in the text itself, or stands for several; its container is left alone.</source>
        <translation>La isosuperficie no está en el propio texto, o vale por varias; su contenedor no se toca.</translation>
    </message>
    <message>
        <source>The container has %1 % of its room now; POV-Ray takes about %2 s instead of %3 s at 640 x 480.</source>
        <translation>El contenedor ocupa ahora el %1 % de antes; POV-Ray tarda unos %2 s en vez de %3 s a 640 x 480.</translation>
    </message>
</context>
<context>
    <name>isoscope::CostStrip</name>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>de %1 a %2</translation>
    </message>
    <message>
        <source>no time</source>
        <translation>sin tiempo</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>What the setting costs in time and loses in pixels over its range; a click sets it.</source>
        <translation>Lo que el ajuste cuesta en tiempo y pierde en píxeles en su intervalo; un clic lo fija.</translation>
    </message>
    <message>
        <source>What each value of the slider above costs and loses. Orange is POV-Ray&apos;s time for a picture, blue the time of this program; both rise upwards by factors. Red below them are lost pixels: holes. The triangle marks the knee: behind it more time changes no pixel. A click sets the value, arrow keys go from one measured value to the next, Return goes to the knee.</source>
        <translation>Lo que cuesta y pierde cada valor del deslizador de arriba. Naranja es el tiempo de POV-Ray para una imagen, azul el de este programa; ambos suben por factores. El rojo de debajo son píxeles perdidos: huecos. El triángulo marca el codo: más allá, más tiempo no cambia ningún píxel. Un clic fija el valor, las flechas van de un valor medido al siguiente, Intro va al codo.</translation>
    </message>
    <message>
        <source>What %1 costs</source>
        <translation>Lo que cuesta %1</translation>
    </message>
    <message>
        <source>POV-Ray %1 ± %2 % at %3</source>
        <translation>POV-Ray %1 ± %2 % en %3</translation>
    </message>
    <message>
        <source>%1; none lost</source>
        <translation>%1; ninguno perdido</translation>
    </message>
    <message>
        <source>%1; %2 lost</source>
        <translation>%1; %2 perdidos</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source> (measured before the last change)</source>
        <translation> (medido antes del último cambio)</translation>
    </message>
    <message>
        <source> (still measuring)</source>
        <translation> (aún midiendo)</translation>
    </message>
    <message>
        <source>At %1: POV-Ray about %2, to %3 %; Isoscope about %4 of processor time</source>
        <translation>En %1: POV-Ray unos %2, al %3 %; Isoscope unos %4 de procesador</translation>
    </message>
    <message>
        <source>Pixels lost: POV-Ray %1, Isoscope %2, of %3 that were traced</source>
        <translation>Píxeles perdidos: POV-Ray %1, Isoscope %2, de %3 trazados</translation>
    </message>
    <message>
        <source>Knee at %1: finer values cost more and change no pixel of this view</source>
        <translation>Codo en %1: valores más finos cuestan más y no cambian ningún píxel de esta vista</translation>
    </message>
    <message>
        <source>Knee at %1: larger values cost more and change no pixel of this view</source>
        <translation>Codo en %1: valores mayores cuestan más y no cambian ningún píxel de esta vista</translation>
    </message>
    <message>
        <source>not measured: not in the picture shown</source>
        <translation>no medido: no está en la imagen mostrada</translation>
    </message>
    <message>
        <source>nothing to measure here</source>
        <translation>nada que medir aquí</translation>
    </message>
    <message>
        <source>measuring what it costs…</source>
        <translation>midiendo lo que cuesta…</translation>
    </message>
    <message>
        <source>What each value costs; it is measured as soon as all rests</source>
        <translation>Lo que cuesta cada valor; se mide en cuanto todo está en reposo</translation>
    </message>
    <message>
        <source>What each value costs; it is measured once the picture shows it</source>
        <translation>Lo que cuesta cada valor; se mide en cuanto la imagen lo muestre</translation>
    </message>
</context>
<context>
    <name>isoscope::DifferenceWindow</name>
    <message>
        <source>%1: the disk and the editor</source>
        <translation>%1: el disco y el editor</translation>
    </message>
    <message>
        <source>Differing lines</source>
        <translation>Líneas que difieren</translation>
    </message>
    <message>
        <source>Take Theirs</source>
        <translation>Tomar el suyo</translation>
    </message>
    <message>
        <source>Show the text of the disk; Undo brings yours back</source>
        <translation>Mostrar el texto del disco; Deshacer recupera el propio</translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation>Conservar el mío</translation>
    </message>
    <message>
        <source>Go on with the text of the editor; saving replaces the file</source>
        <translation>Seguir con el texto del editor; al guardar se reemplaza el archivo</translation>
    </message>
    <message>
        <source>Both texts are the same.</source>
        <translation>Ambos textos son iguales.</translation>
    </message>
    <message>
        <source>−  red: lines that stand only on the disk (%1).   +  green: lines that stand only in the editor (%2).</source>
        <translation>−  rojo: líneas que solo están en el disco (%1).   +  verde: líneas que solo están en el editor (%2).</translation>
    </message>
</context>
<context>
    <name>isoscope::DockTabs</name>
    <message>
        <source>Panels that share this place; right-click to close one or to take it out</source>
        <translation>Paneles que comparten este lugar; clic derecho para cerrar uno o sacarlo</translation>
    </message>
    <message>
        <source>Panels that share this place</source>
        <translation>Paneles que comparten este lugar</translation>
    </message>
    <message>
        <source>&amp;Take Out</source>
        <translation>&amp;Sacar</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Cerrar</translation>
    </message>
</context>
<context>
    <name>isoscope::Docks</name>
    <message>
        <source>Show or hide the panel “%1”</source>
        <translation>Mostrar u ocultar el panel «%1»</translation>
    </message>
</context>
<context>
    <name>isoscope::Document</name>
    <message>
        <source>Untitled</source>
        <translation>Sin título</translation>
    </message>
    <message>
        <source>%1 is a folder.</source>
        <translation>%1 es una carpeta.</translation>
    </message>
    <message>
        <source>%1 is larger than %2 MB: no scene text.</source>
        <translation>%1 supera %2 MB: no es texto de escena.</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>No se puede leer %1: %2.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2.</source>
        <translation>No se puede escribir %1: %2.</translation>
    </message>
</context>
<context>
    <name>isoscope::DocumentController</name>
    <message>
        <source>Scenes (*.pov *.inc *.vl *.vib);;All files (*)</source>
        <translation>Escenas (*.pov *.inc *.vl *.vib);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>%1 (kept)</source>
        <translation>%1 (conservado)</translation>
    </message>
    <message>
        <source>%1 has changes that are not saved.</source>
        <translation>%1 tiene cambios sin guardar.</translation>
    </message>
    <message>
        <source>The text is not saved, and it cannot be kept. %1</source>
        <translation>El texto no está guardado y no se puede conservar. %1</translation>
    </message>
    <message>
        <source>The unsaved text is kept; File, Kept Texts brings it back.</source>
        <translation>El texto sin guardar se conserva; Archivo, Textos conservados lo recupera.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Save the text to its file, then go on</source>
        <translation>Guardar el texto en su archivo y continuar</translation>
    </message>
    <message>
        <source>Keep for Next Time</source>
        <translation>Conservar</translation>
    </message>
    <message>
        <source>Leave the file as it is; the text is offered at the next start</source>
        <translation>Dejar el archivo como está; el texto se ofrece en el próximo inicio</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Give the changes up for good</source>
        <translation>Renunciar a los cambios para siempre</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Go on with this text</source>
        <translation>Seguir con este texto</translation>
    </message>
    <message>
        <source>Open a scene</source>
        <translation>Abrir una escena</translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation>Guardar la escena</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>Guardar como…</translation>
    </message>
    <message>
        <source>Save the text under another name</source>
        <translation>Guardar el texto con otro nombre</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Hide this line; the text stays here</source>
        <translation>Ocultar esta línea; el texto se queda aquí</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Guardado: %1</translation>
    </message>
    <message>
        <source>Read again: %1</source>
        <translation>Leído de nuevo: %1</translation>
    </message>
    <message>
        <source>An unsaved text was kept: %1, %2.</source>
        <translation>Se conservó un texto sin guardar: %1, %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n unsaved texts were kept, the last one: %1, %2.</source>
        <translation>
            <numerusform>Se conservó %n texto sin guardar, el último: %1, %2.</numerusform>
            <numerusform>Se conservaron %n textos sin guardar, el último: %1, %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Bring Back</source>
        <translation>Recuperar</translation>
    </message>
    <message>
        <source>Show the last kept text in the editor</source>
        <translation>Mostrar en el editor el último texto conservado</translation>
    </message>
    <message>
        <source>Show…</source>
        <translation>Mostrar…</translation>
    </message>
    <message>
        <source>List the kept texts with their first lines</source>
        <translation>Lista de los textos conservados con sus primeras líneas</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Más tarde</translation>
    </message>
    <message>
        <source>Keep them, and ask at the next start</source>
        <translation>Conservarlos y preguntar en el próximo inicio</translation>
    </message>
    <message>
        <source>%1 is no longer there; the text has no file now.</source>
        <translation>%1 ya no está; el texto no tiene archivo ahora.</translation>
    </message>
</context>
<context>
    <name>isoscope::EffectsPanel</name>
    <message>
        <source>%1 ms of processor time</source>
        <translation>%1 ms de procesador</translation>
    </message>
    <message>
        <source>Some light is cut short; %1</source>
        <translation>Parte de la luz se abrevia; %1</translation>
    </message>
    <message>
        <source>%1 rays, %2 evaluations</source>
        <translation>%1 rayos, %2 evaluaciones</translation>
    </message>
    <message>
        <source>Cost of all stages</source>
        <translation>Coste de todas las etapas</translation>
    </message>
    <message>
        <source>While &amp;moving at most</source>
        <translation>Al &amp;mover, como máximo</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>sin límite</translation>
    </message>
    <message>
        <source>Time for a moving picture</source>
        <translation>Tiempo para una imagen en movimiento</translation>
    </message>
    <message>
        <source>While the view or a number moves, the dearest effects are left out until a picture takes no longer; they come back at rest</source>
        <translation>Mientras la vista o un número se mueve, los efectos más caros se omiten hasta que una imagen no tarde más; vuelven en reposo</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>Efecto</translation>
    </message>
    <message>
        <source>Rays</source>
        <translation>Rayos</translation>
    </message>
    <message>
        <source>Evaluations</source>
        <translation>Evaluaciones</translation>
    </message>
    <message>
        <source>CPU ms</source>
        <translation>ms de CPU</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Por qué</translation>
    </message>
    <message>
        <source>Effects of the picture</source>
        <translation>Efectos de la imagen</translation>
    </message>
    <message>
        <source>What the picture is made of, and what each part has cost</source>
        <translation>De qué se compone la imagen y lo que ha costado cada parte</translation>
    </message>
    <message>
        <source>Without its mark an effect is left out of this view, never of an exported picture</source>
        <translation>Sin su marca, un efecto se omite en esta vista, nunca en una imagen exportada</translation>
    </message>
    <message>
        <source>Stages of drawing, in their order</source>
        <translation>Etapas del dibujo, en su orden</translation>
    </message>
    <message>
        <source>Rays that the effect has sent</source>
        <translation>Rayos que ha enviado el efecto</translation>
    </message>
    <message>
        <source>Evaluations of functions that it has caused</source>
        <translation>Evaluaciones de funciones que ha causado</translation>
    </message>
    <message>
        <source>Processor time of all threads, in milliseconds</source>
        <translation>Tiempo de procesador de todos los hilos, en milisegundos</translation>
    </message>
    <message>
        <source>What in the scene calls for it, or why nothing does</source>
        <translation>Qué en la escena lo pide, o por qué nada lo hace</translation>
    </message>
    <message>
        <source>No picture yet</source>
        <translation>Aún no hay imagen</translation>
    </message>
    <message>
        <source>Left out of this view. %1</source>
        <translation>Omitido en esta vista. %1</translation>
    </message>
    <message>
        <source>Left out while moving. %1</source>
        <translation>Omitido al mover. %1</translation>
    </message>
    <message>
        <source>%1 roots, %2 misses</source>
        <translation>%1 raíces, %2 sin raíz</translation>
    </message>
    <message>
        <source>, %1 not certain</source>
        <translation>, %1 sin certeza</translation>
    </message>
</context>
<context>
    <name>isoscope::EmptyTextHint</name>
    <message>
        <source>Type a formula, such as x*x + y*y + z*z - 1, or a scene</source>
        <translation>Escriba una fórmula, como x*x + y*y + z*z - 1, o una escena</translation>
    </message>
</context>
<context>
    <name>isoscope::EvaluatePanel</name>
    <message>
        <source>The isosurface whose settings are tried.</source>
        <translation>La isosuperficie cuyos ajustes se prueban.</translation>
    </message>
    <message>
        <source>Try settings of evaluate, or stop</source>
        <translation>Probar ajustes de evaluate, o detener</translation>
    </message>
    <message>
        <source>Progress of the trials</source>
        <translation>Progreso de las pruebas</translation>
    </message>
    <message>
        <source>How many of the settings are tried</source>
        <translation>Cuántos de los ajustes se han probado</translation>
    </message>
    <message>
        <source>Whether evaluate pays</source>
        <translation>Si evaluate compensa</translation>
    </message>
    <message>
        <source>Write Into the Text</source>
        <translation>Escribir en el texto</translation>
    </message>
    <message>
        <source>Gives the isosurface the chosen setting; Undo takes it back.</source>
        <translation>Da a la isosuperficie el ajuste elegido; Deshacer lo anula.</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Ajuste</translation>
    </message>
    <message>
        <source>Evaluations per pixel</source>
        <translation>Evaluaciones por píxel</translation>
    </message>
    <message>
        <source>Pixels lost or wrong</source>
        <translation>Píxeles perdidos o erróneos</translation>
    </message>
    <message>
        <source>Settings that were tried</source>
        <translation>Ajustes que se probaron</translation>
    </message>
    <message>
        <source>Enter or a double click writes the setting into the text</source>
        <translation>Intro o un doble clic escribe el ajuste en el texto</translation>
    </message>
    <message>
        <source>evaluate 0.0000, 0.00, 0.00 (pays most)__</source>
        <translation>evaluate 0.0000, 0.00, 0.00 (compensa más)__</translation>
    </message>
    <message>
        <source>Evaluations per pixel__</source>
        <translation>Evaluaciones por píxel__</translation>
    </message>
    <message>
        <source>%1 (pays most)</source>
        <translation>%1 (compensa más)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Measure Again</source>
        <translation>Medir de nuevo</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Medir</translation>
    </message>
    <message>
        <source>End the trials</source>
        <translation>Terminar las pruebas</translation>
    </message>
    <message>
        <source>Tries numbers of evaluate in a small picture of this view</source>
        <translation>Prueba números de evaluate en una imagen pequeña de esta vista</translation>
    </message>
    <message>
        <source>The scene has no isosurface.</source>
        <translation>La escena no tiene isosuperficie.</translation>
    </message>
    <message>
        <source>Each setting is tried in a small picture of this view…</source>
        <translation>Cada ajuste se prueba en una imagen pequeña de esta vista…</translation>
    </message>
    <message>
        <source>What evaluate would cost and lose in this view, beside the proven max_gradient.</source>
        <translation>Lo que evaluate costaría y perdería en esta vista, junto al max_gradient demostrado.</translation>
    </message>
    <message>
        <source>Measured before the last change of scene or view.</source>
        <translation>Medido antes del último cambio de escena o vista.</translation>
    </message>
    <message>
        <source>evaluate does not pay in this view.</source>
        <translation>evaluate no compensa en esta vista.</translation>
    </message>
    <message>
        <source>evaluate saves %1 % of the evaluations in this view.</source>
        <translation>evaluate ahorra %1 % de las evaluaciones en esta vista.</translation>
    </message>
    <message>
        <source>No max_gradient is proven to be enough; this evaluate loses nothing in this view.</source>
        <translation>No está demostrado que ningún max_gradient baste; este evaluate no pierde nada en esta vista.</translation>
    </message>
</context>
<context>
    <name>isoscope::ExampleMenu</name>
    <message>
        <source>Open the example %1</source>
        <translation>Abrir el ejemplo %1</translation>
    </message>
</context>
<context>
    <name>isoscope::ExportController</name>
    <message>
        <source>The text shows no object to write.</source>
        <translation>El texto no muestra ningún objeto que escribir.</translation>
    </message>
    <message>
        <source>The images of height fields can only be written to files.</source>
        <translation>Las imágenes de campos de alturas solo se pueden escribir en archivos.</translation>
    </message>
    <message>
        <source>The scene has no isosurface to write.</source>
        <translation>La escena no tiene isosuperficie que escribir.</translation>
    </message>
    <message>
        <source>The isosurface is on the clipboard.</source>
        <translation>La isosuperficie está en el portapapeles.</translation>
    </message>
    <message>
        <source>Write the objects</source>
        <translation>Escribir los objetos</translation>
    </message>
    <message>
        <source>Write the isosurface</source>
        <translation>Escribir la isosuperficie</translation>
    </message>
    <message>
        <source>Write a scene for POV-Ray</source>
        <translation>Escribir una escena para POV-Ray</translation>
    </message>
    <message>
        <source>There is no scene to write yet.</source>
        <translation>Aún no hay escena que escribir.</translation>
    </message>
    <message>
        <source>Write the objects for VirtuaLight</source>
        <translation>Escribir los objetos para VirtuaLight</translation>
    </message>
    <message>
        <source>VirtuaLight files (*%1);;All files (*)</source>
        <translation>Archivos de VirtuaLight (*%1);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>POV-Ray files (*%1);;All files (*)</source>
        <translation>Archivos de POV-Ray (*%1);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>%1 is the scene itself; an export needs a name of its own.</source>
        <translation>%1 es la propia escena; una exportación necesita otro nombre.</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Escrito: %1</translation>
    </message>
    <message>
        <source>No export of Isoscope made %1.</source>
        <translation>%1 no lo hizo ninguna exportación de Isoscope.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
    </message>
    <message>
        <source>What stands in the file now is lost</source>
        <translation>Lo que hay ahora en el archivo se pierde</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Conservar</translation>
    </message>
    <message>
        <source>Write nothing</source>
        <translation>No escribir nada</translation>
    </message>
    <message>
        <source>There is no picture to export yet.</source>
        <translation>Aún no hay imagen que exportar.</translation>
    </message>
    <message>
        <source>There is no text that POV-Ray could draw.</source>
        <translation>No hay texto que POV-Ray pueda dibujar.</translation>
    </message>
    <message>
        <source>POV-Ray reads its own language only; File ▸ Export writes it.</source>
        <translation>POV-Ray solo lee su propio lenguaje; Archivo ▸ Exportar lo escribe.</translation>
    </message>
    <message>
        <source>Not given to POV-Ray: %1.</source>
        <translation>No se da a POV-Ray: %1.</translation>
    </message>
    <message>
        <source>There is no picture to copy yet.</source>
        <translation>Aún no hay imagen que copiar.</translation>
    </message>
    <message>
        <source>The picture is on the clipboard.</source>
        <translation>La imagen está en el portapapeles.</translation>
    </message>
    <message>
        <source>The text has errors, or there is none.</source>
        <translation>El texto tiene errores, o no lo hay.</translation>
    </message>
    <message>
        <source>There is no timeline to write. The panel “Timeline” makes one.</source>
        <translation>No hay línea de tiempo que escribir. El panel «Línea de tiempo» la crea.</translation>
    </message>
    <message>
        <source>Write an animation for POV-Ray</source>
        <translation>Escribir una animación para POV-Ray</translation>
    </message>
    <message>
        <source>%1 is no export of Isoscope; choose another name.</source>
        <translation>%1 no es una exportación de Isoscope; elija otro nombre.</translation>
    </message>
    <message>
        <source>There is no isosurface to export.</source>
        <translation>No hay isosuperficie que exportar.</translation>
    </message>
    <message>
        <source>There is no view to write yet.</source>
        <translation>Aún no hay vista que escribir.</translation>
    </message>
    <message>
        <source>A camera can only be written into a text for POV-Ray.</source>
        <translation>Una cámara solo se puede escribir en un texto para POV-Ray.</translation>
    </message>
    <message>
        <source>The camera stands in an include file, which is not changed.</source>
        <translation>La cámara está en un archivo de inclusión, que no se cambia.</translation>
    </message>
    <message>
        <source>The view is the camera of the text now.</source>
        <translation>La vista es ahora la cámara del texto.</translation>
    </message>
    <message>
        <source>No bound is proven (so far): there is no comment of it.</source>
        <translation>No hay (todavía) ninguna cota demostrada: no hay comentario.</translation>
    </message>
</context>
<context>
    <name>isoscope::ExternalChanges</name>
    <message>
        <source>See the Difference</source>
        <translation>Ver la diferencia</translation>
    </message>
    <message>
        <source>Show the lines in which the disk and the editor differ</source>
        <translation>Mostrar las líneas en que difieren el disco y el editor</translation>
    </message>
    <message>
        <source>Another program changed %1.</source>
        <translation>Otro programa cambió %1.</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Recargar</translation>
    </message>
    <message>
        <source>Show what stands on the disk now</source>
        <translation>Mostrar lo que hay ahora en el disco</translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation>Ignorar</translation>
    </message>
    <message>
        <source>Go on with the text as it is here; saving asks again</source>
        <translation>Seguir con el texto como está aquí; al guardar se pregunta de nuevo</translation>
    </message>
    <message>
        <source>Not saved: another program changed %1 meanwhile.</source>
        <translation>No guardado: otro programa cambió %1 entretanto.</translation>
    </message>
    <message>
        <source>Another program changed %1, and so did you.</source>
        <translation>Otro programa cambió %1, y usted también.</translation>
    </message>
    <message>
        <source>Take Theirs</source>
        <translation>Tomar el suyo</translation>
    </message>
    <message>
        <source>Show what stands on the disk now; Undo brings your text back</source>
        <translation>Mostrar lo que hay ahora en el disco; Deshacer recupera su texto</translation>
    </message>
    <message>
        <source>Save Mine</source>
        <translation>Guardar el mío</translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation>Conservar el mío</translation>
    </message>
    <message>
        <source>Replace the file by the text of the editor</source>
        <translation>Reemplazar el archivo por el texto del editor</translation>
    </message>
    <message>
        <source>Go on with your text; saving replaces the file</source>
        <translation>Seguir con su texto; al guardar se reemplaza el archivo</translation>
    </message>
    <message>
        <source>Not Now</source>
        <translation>Ahora no</translation>
    </message>
    <message>
        <source>Change nothing, neither here nor on the disk</source>
        <translation>No cambiar nada, ni aquí ni en el disco</translation>
    </message>
    <message>
        <source>Not saved: %1 is no longer there.</source>
        <translation>No guardado: %1 ya no está.</translation>
    </message>
    <message>
        <source>%1 is no longer there; its text stands only here.</source>
        <translation>%1 ya no está; su texto solo está aquí.</translation>
    </message>
    <message>
        <source>Write It Again</source>
        <translation>Escribirlo de nuevo</translation>
    </message>
    <message>
        <source>Save the text under its old name</source>
        <translation>Guardar el texto con su nombre anterior</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>Guardar como…</translation>
    </message>
    <message>
        <source>Save the text under another name</source>
        <translation>Guardar el texto con otro nombre</translation>
    </message>
    <message>
        <source>Leave the file away; the text counts as unsaved</source>
        <translation>No escribir el archivo; el texto cuenta como no guardado</translation>
    </message>
</context>
<context>
    <name>isoscope::FileWriter</name>
    <message>
        <source>The text writes to files beside the scene: %1</source>
        <translation>El texto escribe archivos junto a la escena: %1</translation>
    </message>
    <message>
        <source>Allow</source>
        <translation>Permitir</translation>
    </message>
    <message>
        <source>Write these files now, and again when they change, until the text is closed</source>
        <translation>Escribir estos archivos ahora, y de nuevo cuando cambien, hasta cerrar el texto</translation>
    </message>
    <message>
        <source>The text would replace %1, which this scene did not write.</source>
        <translation>El texto reemplazaría %1, que esta escena no escribió.</translation>
    </message>
    <message>
        <source>Replace %1</source>
        <translation>Reemplazar %1</translation>
    </message>
    <message>
        <source>What stands in the file now is lost</source>
        <translation>Lo que hay ahora en el archivo se pierde</translation>
    </message>
    <message>
        <source>The text adds to %1, each time it is read.</source>
        <translation>El texto añade a %1 cada vez que se lee.</translation>
    </message>
    <message>
        <source>Add Once</source>
        <translation>Añadir una vez</translation>
    </message>
    <message>
        <source>Write to the file once more</source>
        <translation>Escribir en el archivo una vez más</translation>
    </message>
    <message>
        <source>The text writes %1. Save the scene first: files are written beside it only.</source>
        <translation>El texto escribe %1. Guarde antes la escena: los archivos solo se escriben junto a ella.</translation>
    </message>
    <message>
        <source>Not Now</source>
        <translation>Ahora no</translation>
    </message>
    <message>
        <source>Write nothing; #read and #include of the same text find it all the same</source>
        <translation>No escribir nada; #read e #include del mismo texto lo encuentran igualmente</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Escrito: %1</translation>
    </message>
    <message>
        <source>Not written: %1 (%2)</source>
        <translation>No escrito: %1 (%2)</translation>
    </message>
</context>
<context>
    <name>isoscope::FindBar</name>
    <message>
        <source>Find and replace</source>
        <translation>Buscar y reemplazar</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>What to look for. Enter: next, Shift+Enter: previous</source>
        <translation>Qué buscar. Intro: siguiente, Mayús+Intro: anterior</translation>
    </message>
    <message>
        <source>Upper and lower case differ</source>
        <translation>Mayúsculas y minúsculas difieren</translation>
    </message>
    <message>
        <source>Match case</source>
        <translation>Mayúsculas</translation>
    </message>
    <message>
        <source>Whole words only</source>
        <translation>Solo palabras enteras</translation>
    </message>
    <message>
        <source>Whole words</source>
        <translation>Palabras enteras</translation>
    </message>
    <message>
        <source>Regular expression; \1 in the replacement is the first group</source>
        <translation>Expresión regular; \1 en el reemplazo es el primer grupo</translation>
    </message>
    <message>
        <source>Regular expression</source>
        <translation>Expresión regular</translation>
    </message>
    <message>
        <source>Number of matches</source>
        <translation>Número de coincidencias</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Previous match (Shift+F3)</source>
        <translation>Coincidencia anterior (Mayús+F3)</translation>
    </message>
    <message>
        <source>Previous match</source>
        <translation>Coincidencia anterior</translation>
    </message>
    <message>
        <source>Next match (F3)</source>
        <translation>Coincidencia siguiente (F3)</translation>
    </message>
    <message>
        <source>Next match</source>
        <translation>Coincidencia siguiente</translation>
    </message>
    <message>
        <source>Close (Escape)</source>
        <translation>Cerrar (Escape)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Replace with</source>
        <translation>Reemplazar con</translation>
    </message>
    <message>
        <source>What to put in its place. Enter replaces the match</source>
        <translation>Qué poner en su lugar. Intro reemplaza la coincidencia</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
    </message>
    <message>
        <source>Replaces the selected match and goes to the next</source>
        <translation>Reemplaza la coincidencia seleccionada y va a la siguiente</translation>
    </message>
    <message>
        <source>Replace all</source>
        <translation>Reemplazar todo</translation>
    </message>
    <message>
        <source>Replaces every match; one undo brings them back</source>
        <translation>Reemplaza todas las coincidencias; un solo Deshacer las recupera</translation>
    </message>
    <message>
        <source>Invalid</source>
        <translation>No válida</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguna</translation>
    </message>
    <message>
        <source>%1 found</source>
        <translation>%1 halladas</translation>
    </message>
    <message>
        <source>Matches in the text</source>
        <translation>Coincidencias en el texto</translation>
    </message>
    <message>
        <source>The regular expression is not valid: %1</source>
        <translation>La expresión regular no es válida: %1</translation>
    </message>
    <message>
        <source>%1 replaced</source>
        <translation>%1 reemplazadas</translation>
    </message>
    <message>
        <source>expression is too complex</source>
        <translation>la expresión es demasiado compleja</translation>
    </message>
</context>
<context>
    <name>isoscope::FormulaOffer</name>
    <message>
        <source>Make It an Isosurface</source>
        <translation>Hacerla isosuperficie</translation>
    </message>
    <message>
        <source>A formula shows nothing by itself. As an isosurface it can be seen.</source>
        <translation>Una fórmula sola no muestra nada. Como isosuperficie se puede ver.</translation>
    </message>
    <message>
        <source>Replace the formula by its isosurface; Undo brings it back</source>
        <translation>Reemplazar la fórmula por su isosuperficie; Deshacer la recupera</translation>
    </message>
    <message>
        <source>Not Now</source>
        <translation>Ahora no</translation>
    </message>
    <message>
        <source>Leave the text as it is</source>
        <translation>Dejar el texto como está</translation>
    </message>
</context>
<context>
    <name>isoscope::FormulaPanel</name>
    <message>
        <source>no infinite slope</source>
        <translation>sin pendiente infinita</translation>
    </message>
    <message>
        <source>no overflow</source>
        <translation>sin desbordamiento</translation>
    </message>
    <message>
        <source>%1 times as exact</source>
        <translation>%1 veces más exacto</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>exacto</translation>
    </message>
    <message>
        <source>%1 % less time</source>
        <translation>%1 % menos de tiempo</translation>
    </message>
    <message>
        <source>no seam</source>
        <translation>sin costura</translation>
    </message>
    <message>
        <source>the same operations</source>
        <translation>las mismas operaciones</translation>
    </message>
    <message>
        <source>proven</source>
        <translation>demostrado</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>medido</translation>
    </message>
    <message>
        <source>The isosurface whose function is written otherwise.</source>
        <translation>La isosuperficie cuya función se escribe de otro modo.</translation>
    </message>
    <message>
        <source>What the chosen rewrite does, and how sure that is</source>
        <translation>Lo que hace la reescritura elegida, y lo segura que es</translation>
    </message>
    <message>
        <source>Progress of the search for rewrites</source>
        <translation>Progreso de la búsqueda de reescrituras</translation>
    </message>
    <message>
        <source>How much of the search is done</source>
        <translation>Qué parte de la búsqueda está hecha</translation>
    </message>
    <message>
        <source>Search or stop</source>
        <translation>Buscar o detener</translation>
    </message>
    <message>
        <source>Could be written as</source>
        <translation>Podría escribirse como</translation>
    </message>
    <message>
        <source>Gain in POV-Ray</source>
        <translation>Ganancia en POV-Ray</translation>
    </message>
    <message>
        <source>Certainty</source>
        <translation>Certeza</translation>
    </message>
    <message>
        <source>Other ways to write the function</source>
        <translation>Otras formas de escribir la función</translation>
    </message>
    <message>
        <source>Choose one to read what it does; Enter or a double click writes it</source>
        <translation>Elija una para leer lo que hace; Intro o un doble clic la escribe</translation>
    </message>
    <message>
        <source>Rewrite</source>
        <translation>Reescribir</translation>
    </message>
    <message>
        <source>Changes the text so; Undo takes it back.</source>
        <translation>Cambia así el texto; Deshacer lo anula.</translation>
    </message>
    <message>
        <source>Write the chosen rewrite into the text</source>
        <translation>Escribir la reescritura elegida en el texto</translation>
    </message>
    <message>
        <source>Derivatives as POV-Ray&apos;s text</source>
        <translation>Derivadas como texto de POV-Ray</translation>
    </message>
    <message>
        <source>The derivatives in x, y and z, the length of the gradient, and a function with the same surface whose gradient is 1 on it</source>
        <translation>Las derivadas en x, y y z, la longitud del gradiente, y una función con la misma superficie cuyo gradiente es 1 en ella</translation>
    </message>
    <message>
        <source>Copy Derivatives</source>
        <translation>Copiar derivadas</translation>
    </message>
    <message>
        <source>Puts the declarations on the clipboard.</source>
        <translation>Pone las declaraciones en el portapapeles.</translation>
    </message>
    <message>
        <source>The derivatives are on the clipboard.</source>
        <translation>Las derivadas están en el portapapeles.</translation>
    </message>
    <message>
        <source>Insert Derivatives</source>
        <translation>Insertar derivadas</translation>
    </message>
    <message>
        <source>Writes the declarations in front of the isosurface; Undo takes it back.</source>
        <translation>Escribe las declaraciones delante de la isosuperficie; Deshacer lo anula.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>End the search</source>
        <translation>Terminar la búsqueda</translation>
    </message>
    <message>
        <source>Look for other ways to write the function</source>
        <translation>Buscar otras formas de escribir la función</translation>
    </message>
    <message>
        <source>The scene has no isosurface.</source>
        <translation>La escena no tiene isosuperficie.</translation>
    </message>
    <message>
        <source>Being found out…</source>
        <translation>Se está averiguando…</translation>
    </message>
    <message>
        <source>It is found out once nothing moves.</source>
        <translation>Se averigua en cuanto nada se mueve.</translation>
    </message>
    <message>
        <source>There is no rewrite that pays.</source>
        <translation>No hay ninguna reescritura que compense.</translation>
    </message>
    <message>
        <source>Choose a rewrite to read what it does, and how sure that is.</source>
        <translation>Elija una reescritura para leer lo que hace, y lo segura que es.</translation>
    </message>
</context>
<context>
    <name>isoscope::FrameWriter</name>
    <message>
        <source>Frame %1: %2</source>
        <translation>Fotograma %1: %2</translation>
    </message>
</context>
<context>
    <name>isoscope::FunctionBrowser</name>
    <message>
        <source>Parameter</source>
        <translation>Parámetro</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Usual</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Intervalo</translation>
    </message>
    <message>
        <source>&lt;tr&gt;&lt;td&gt;%1&amp;nbsp;&amp;nbsp;&lt;/td&gt;&lt;td&gt;%2&amp;nbsp;&amp;nbsp;&lt;/td&gt;&lt;td&gt;%3 to %4&lt;/td&gt;&lt;/tr&gt;</source>
        <translation>&lt;tr&gt;&lt;td&gt;%1&amp;nbsp;&amp;nbsp;&lt;/td&gt;&lt;td&gt;%2&amp;nbsp;&amp;nbsp;&lt;/td&gt;&lt;td&gt;de %3 a %4&lt;/td&gt;&lt;/tr&gt;</translation>
    </message>
    <message>
        <source>Functions</source>
        <translation>Funciones</translation>
    </message>
    <message>
        <source>Search functions</source>
        <translation>Buscar funciones</translation>
    </message>
    <message>
        <source>Words of the name or of parameters. Down goes to the list, Enter inserts</source>
        <translation>Palabras del nombre o de parámetros. Abajo va a la lista, Intro inserta</translation>
    </message>
    <message>
        <source>Double-click or Enter inserts an isosurface of the function</source>
        <translation>Doble clic o Intro inserta una isosuperficie de la función</translation>
    </message>
    <message>
        <source>No function matches the search.</source>
        <translation>Ninguna función coincide con la búsqueda.</translation>
    </message>
    <message>
        <source>About the function</source>
        <translation>Sobre la función</translation>
    </message>
    <message>
        <source>Formula and parameters of the selected function</source>
        <translation>Fórmula y parámetros de la función seleccionada</translation>
    </message>
    <message>
        <source>Insert isosurface</source>
        <translation>Insertar isosuperficie</translation>
    </message>
    <message>
        <source>Writes a whole isosurface that shows the function, beside what is there (Enter)</source>
        <translation>Escribe una isosuperficie entera que muestra la función, junto a lo que hay (Intro)</translation>
    </message>
    <message>
        <source>Insert call</source>
        <translation>Insertar llamada</translation>
    </message>
    <message>
        <source>Writes just the call at the caret (Shift+Enter)</source>
        <translation>Escribe solo la llamada en el cursor (Mayús+Intro)</translation>
    </message>
</context>
<context>
    <name>isoscope::GalleryController</name>
    <message>
        <source>Two shapes with a blend between them, and what each number does.</source>
        <translation>Dos formas con una transición entre ellas, y lo que hace cada número.</translation>
    </message>
    <message>
        <source>What a wrong max_gradient does to POV-Ray&apos;s picture.</source>
        <translation>Lo que un max_gradient erróneo hace en la imagen de POV-Ray.</translation>
    </message>
    <message>
        <source>A box whose cross-section turns with its height.</source>
        <translation>Una caja cuya sección gira con la altura.</translation>
    </message>
    <message>
        <source>The product of two functions melts their surfaces.</source>
        <translation>El producto de dos funciones funde sus superficies.</translation>
    </message>
    <message>
        <source>A polynomial of the sixth degree.</source>
        <translation>Un polinomio de sexto grado.</translation>
    </message>
    <message>
        <source>Noise added to a ball makes a stone of it.</source>
        <translation>El ruido sumado a una bola la vuelve piedra.</translation>
    </message>
    <message>
        <source>A height for every place, from f_ridged_mf.</source>
        <translation>Una altura para cada lugar, de f_ridged_mf.</translation>
    </message>
    <message>
        <source>Sines and cosines that part space into two halves.</source>
        <translation>Senos y cosenos que parten el espacio en dos mitades.</translation>
    </message>
    <message>
        <source>A surface without inside or outside.</source>
        <translation>Una superficie sin interior ni exterior.</translation>
    </message>
    <message>
        <source>VirtuaLight: union, intersection and the rest.</source>
        <translation>VirtuaLight: unión, intersección y lo demás.</translation>
    </message>
    <message>
        <source>VirtuaLight: surfaces that it knows by name.</source>
        <translation>VirtuaLight: superficies que conoce por su nombre.</translation>
    </message>
    <message>
        <source>VirtuaLight: polynomials by their coefficients.</source>
        <translation>VirtuaLight: polinomios por sus coeficientes.</translation>
    </message>
    <message>
        <source>VirtuaLight: formulas of your own.</source>
        <translation>VirtuaLight: fórmulas propias.</translation>
    </message>
    <message>
        <source>The text could not be kept in your collection.</source>
        <translation>El texto no se pudo conservar en su colección.</translation>
    </message>
    <message>
        <source>Added to your collection.</source>
        <translation>Añadido a su colección.</translation>
    </message>
    <message>
        <source>“%1” could not be removed.</source>
        <translation>No se pudo quitar «%1».</translation>
    </message>
    <message>
        <source>“%1” is removed from your collection.</source>
        <translation>«%1» se quitó de su colección.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Put it back into your collection</source>
        <translation>Devolverlo a su colección</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Leave it removed</source>
        <translation>Dejarlo quitado</translation>
    </message>
    <message>
        <source>“%1” could not be renamed.</source>
        <translation>No se pudo cambiar el nombre de «%1».</translation>
    </message>
    <message>
        <source>Renamed to “%1”.</source>
        <translation>Ahora se llama «%1».</translation>
    </message>
</context>
<context>
    <name>isoscope::GalleryModel</name>
    <message>
        <source>Function</source>
        <translation>Función</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Patrón</translation>
    </message>
    <message>
        <source>Example</source>
        <translation>Ejemplo</translation>
    </message>
    <message>
        <source>POV-Ray</source>
        <translation>POV-Ray</translation>
    </message>
    <message>
        <source>My collection</source>
        <translation>Mi colección</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lección</translation>
    </message>
</context>
<context>
    <name>isoscope::GalleryPanel</name>
    <message>
        <source>Gallery</source>
        <translation>Galería</translation>
    </message>
    <message>
        <source>Search the gallery</source>
        <translation>Buscar en la galería</translation>
    </message>
    <message>
        <source>Words of title, sentence or kind. Down goes to the list, Enter opens</source>
        <translation>Palabras de título, frase o tipo. Abajo va a la lista, Intro abre</translation>
    </message>
    <message>
        <source>A click or Enter opens the scene</source>
        <translation>Un clic o Intro abre la escena</translation>
    </message>
    <message>
        <source>Scenes of the gallery</source>
        <translation>Escenas de la galería</translation>
    </message>
    <message>
        <source>No scene matches the search.</source>
        <translation>Ninguna escena coincide con la búsqueda.</translation>
    </message>
    <message>
        <source>Add to My Collection</source>
        <translation>Añadir a mi colección</translation>
    </message>
    <message>
        <source>Keep the open text in the gallery</source>
        <translation>Conservar el texto abierto en la galería</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>A&amp;brir</translation>
    </message>
    <message>
        <source>&amp;Insert Isosurface</source>
        <translation>&amp;Insertar isosuperficie</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>Cambiar &amp;nombre</translation>
    </message>
    <message>
        <source>&amp;Remove from My Collection</source>
        <translation>&amp;Quitar de mi colección</translation>
    </message>
</context>
<context>
    <name>isoscope::GradientPanel</name>
    <message>
        <source>The isosurface whose gradient is measured.</source>
        <translation>La isosuperficie cuyo gradiente se mide.</translation>
    </message>
    <message>
        <source>On the surface</source>
        <translation>En la superficie</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Usar</translation>
    </message>
    <message>
        <source>Writes the suggested max_gradient into the text.</source>
        <translation>Escribe en el texto el max_gradient propuesto.</translation>
    </message>
    <message>
        <source>Use the suggested max_gradient</source>
        <translation>Usar el max_gradient propuesto</translation>
    </message>
    <message>
        <source>Writes the value that is enough for this view into the text.</source>
        <translation>Escribe en el texto el valor que basta para esta vista.</translation>
    </message>
    <message>
        <source>Use the max_gradient that is enough for this view</source>
        <translation>Usar el max_gradient que basta para esta vista</translation>
    </message>
    <message>
        <source>Go There</source>
        <translation>Ir allí</translation>
    </message>
    <message>
        <source>Shows the steepest place of the function in the picture.</source>
        <translation>Muestra en la imagen el lugar más empinado de la función.</translation>
    </message>
    <message>
        <source>Show the steepest place in the picture</source>
        <translation>Mostrar en la imagen el lugar más empinado</translation>
    </message>
    <message>
        <source>max_gradient</source>
        <translation>max_gradient</translation>
    </message>
    <message>
        <source>How steep POV-Ray takes the function to be: the number in the text, and what it is worth. Where the function is steeper, POV-Ray steps over the surface, which leaves holes.</source>
        <translation>Lo empinada que POV-Ray supone la función: el número del texto y lo que vale. Donde la función es más empinada, POV-Ray se salta la superficie y deja huecos.</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Huecos</translation>
    </message>
    <message>
        <source>Pixels of this view that POV-Ray&apos;s picture gets wrong with the present setting: lost, gained, or found at a wrong place.</source>
        <translation>Píxeles de esta vista que la imagen de POV-Ray tiene mal con el ajuste actual: perdidos, de más o en lugar erróneo.</translation>
    </message>
    <message>
        <source>Along rays</source>
        <translation>En los rayos</translation>
    </message>
    <message>
        <source>How steep the function is along the rays of this view: the steepest slope that POV-Ray meets, and reports.</source>
        <translation>Lo empinada que es la función a lo largo de los rayos de esta vista: la mayor pendiente que POV-Ray encuentra y comunica.</translation>
    </message>
    <message>
        <source>How steep the function is where you see the surface: the largest gradient at its visible points.</source>
        <translation>Lo empinada que es la función donde se ve la superficie: el mayor gradiente en sus puntos visibles.</translation>
    </message>
    <message>
        <source>Proven</source>
        <translation>Demostrado</translation>
    </message>
    <message>
        <source>How steep the function gets anywhere in its container. The largest gradient lies between these: the first is reached at the place shown, the second nowhere exceeded.</source>
        <translation>Hasta dónde llega la pendiente de la función en su contenedor. El mayor gradiente está entre estos: el primero se alcanza en el lugar mostrado, el segundo no se supera en ninguno.</translation>
    </message>
    <message>
        <source>Suggested</source>
        <translation>Propuesto</translation>
    </message>
    <message>
        <source>What to write for a picture without holes from every side: the smallest round value that no gradient in the container exceeds.</source>
        <translation>Qué escribir para una imagen sin huecos desde todos los lados: el menor valor redondo que ningún gradiente del contenedor supera.</translation>
    </message>
    <message>
        <source>This view</source>
        <translation>Esta vista</translation>
    </message>
    <message>
        <source>What is enough for the present view, and faster: the smallest value that loses no pixel of it. Nothing is proven for other views.</source>
        <translation>Lo que basta para la vista actual, y es más rápido: el menor valor que no pierde ninguno de sus píxeles. Nada se demuestra para otras vistas.</translation>
    </message>
    <message>
        <source>What to do about an infinite gradient</source>
        <translation>Qué hacer con un gradiente infinito</translation>
    </message>
    <message>
        <source>none in %1 pixels</source>
        <translation>ninguno en %1 píxeles</translation>
    </message>
    <message>
        <source>%1 lost, %2 gained, %3 at a wrong place, of %4 pixels</source>
        <translation>%1 perdidos, %2 de más, %3 en lugar erróneo, de %4 píxeles</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>%1: enough for this view, not proven for others</source>
        <translation>%1: basta para esta vista, no demostrado para otras</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>, tightening</source>
        <translation>, afinando</translation>
    </message>
    <message>
        <source>, budget spent</source>
        <translation>, presupuesto agotado</translation>
    </message>
    <message>
        <source>unbounded: %1 at %2</source>
        <translation>sin cota: %1 en %2</translation>
    </message>
    <message>
        <source>%1 to %2%3, the first at %4</source>
        <translation>de %1 a %2%3, el primero en %4</translation>
    </message>
    <message>
        <source>%1: enough but for jumps</source>
        <translation>%1: basta salvo en saltos</translation>
    </message>
    <message>
        <source>%1: proven for every view</source>
        <translation>%1: demostrado para toda vista</translation>
    </message>
    <message>
        <source>at most %1 so far</source>
        <translation>como máximo %1 hasta ahora</translation>
    </message>
    <message>
        <source>The scene has no isosurface to measure.</source>
        <translation>La escena no tiene isosuperficie que medir.</translation>
    </message>
    <message>
        <source>No bound at %1: %2. %3</source>
        <translation>Sin cota en %1: %2. %3</translation>
    </message>
    <message>
        <source>Farther than %1 from such places no gradient exceeds %2.</source>
        <translation>A más de %1 de esos lugares ningún gradiente supera %2.</translation>
    </message>
    <message>
        <source>Beside jumps no gradient exceeds %1.</source>
        <translation>Fuera de los saltos ningún gradiente supera %1.</translation>
    </message>
    <message>
        <source>The bound holds beside places where the function may jump; none was found.</source>
        <translation>La cota vale fuera de lugares donde la función pueda saltar; no se halló ninguno.</translation>
    </message>
    <message>
        <source>At the mouse</source>
        <translation>Bajo el ratón</translation>
    </message>
    <message>
        <source>How steep the function is at the point under the mouse, in the picture, the cross-section or a chart, beside max_gradient.</source>
        <translation>Lo empinada que es la función en el punto bajo el ratón, en la imagen, la sección o un gráfico, junto a max_gradient.</translation>
    </message>
    <message>
        <source>f is undefined</source>
        <translation>f no está definida</translation>
    </message>
    <message>
        <source>infinite</source>
        <translation>infinito</translation>
    </message>
    <message>
        <source>%1: %2 % of max_gradient</source>
        <translation>%1: %2 % de max_gradient</translation>
    </message>
</context>
<context>
    <name>isoscope::HelpBrowser</name>
    <message>
        <source>Page of the help</source>
        <translation>Página de la ayuda</translation>
    </message>
</context>
<context>
    <name>isoscope::HelpController</name>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
    <message>
        <source>&lt;p&gt;Lessons, and pages about the language, the functions and the window. F1 opens the one about what has the focus.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Lecciones, y páginas sobre el lenguaje, las funciones y la ventana. F1 abre la de lo que tiene el foco.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>isoscope::HelpPanel</name>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>To the page before (Alt+Left)</source>
        <translation>A la página anterior (Alt+Izquierda)</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Adelante</translation>
    </message>
    <message>
        <source>To the next page (Alt+Right)</source>
        <translation>A la página siguiente (Alt+Derecha)</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Contenido</translation>
    </message>
    <message>
        <source>The list of all pages</source>
        <translation>La lista de todas las páginas</translation>
    </message>
    <message>
        <source>Search the help</source>
        <translation>Buscar en la ayuda</translation>
    </message>
    <message>
        <source>Words that stand on a page. Down goes to the list, Enter opens</source>
        <translation>Palabras que hay en una página. Abajo va a la lista, Intro abre</translation>
    </message>
    <message>
        <source>Pages of the help</source>
        <translation>Páginas de la ayuda</translation>
    </message>
    <message>
        <source>A click or Enter opens the page</source>
        <translation>Un clic o Intro abre la página</translation>
    </message>
    <message>
        <source>No page has all these words.</source>
        <translation>Ninguna página tiene todas estas palabras.</translation>
    </message>
    <message>
        <source>Find on this page</source>
        <translation>Buscar en esta página</translation>
    </message>
    <message>
        <source>Enter goes to the next place, Shift+Enter to the one before</source>
        <translation>Intro va al lugar siguiente, Mayús+Intro al anterior</translation>
    </message>
    <message>
        <source>Number of places</source>
        <translation>Número de lugares</translation>
    </message>
    <message>
        <source>Find previous</source>
        <translation>Buscar anterior</translation>
    </message>
    <message>
        <source>To the place before</source>
        <translation>Al lugar anterior</translation>
    </message>
    <message>
        <source>Find next</source>
        <translation>Buscar siguiente</translation>
    </message>
    <message>
        <source>To the next place</source>
        <translation>Al lugar siguiente</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s)</source>
        <translation>
            <numerusform>%n lugar</numerusform>
            <numerusform>%n lugares</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>isoscope::HistogramPanel</name>
    <message>
        <source>Histogram of the gradient</source>
        <translation>Histograma del gradiente</translation>
    </message>
    <message>
        <source>How steep the function is, and how often: how much of the container, and of the surface, has which gradient |∇f|.</source>
        <translation>Lo empinada que es la función y con qué frecuencia: qué parte del contenedor y de la superficie tiene cada gradiente |∇f|.</translation>
    </message>
    <message>
        <source>How much is steeper than max_gradient</source>
        <translation>Cuánto es más empinado que max_gradient</translation>
    </message>
    <message>
        <source>gradient</source>
        <translation>gradiente</translation>
    </message>
    <message>
        <source>The gradient of the isosurface is shown here once it is measured.</source>
        <translation>El gradiente de la isosuperficie se muestra aquí una vez medido.</translation>
    </message>
    <message>
        <source>in the container</source>
        <translation>en el contenedor</translation>
    </message>
    <message>
        <source>on the surface</source>
        <translation>en la superficie</translation>
    </message>
    <message>
        <source>max_gradient %1</source>
        <translation>max_gradient %1</translation>
    </message>
    <message>
        <source>attained %1</source>
        <translation>alcanzado %1</translation>
    </message>
    <message>
        <source>proven %1</source>
        <translation>demostrado %1</translation>
    </message>
    <message>
        <source>0 to %1: %2</source>
        <translation>de 0 a %1: %2</translation>
    </message>
    <message>
        <source>|∇f|</source>
        <translation>|∇f|</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Distribution of the gradient</source>
        <translation>Distribución del gradiente</translation>
    </message>
    <message>
        <source>Steeper than max_gradient: %1 of the container, %2 of the surface.</source>
        <translation>Más empinado que max_gradient: %1 del contenedor, %2 de la superficie.</translation>
    </message>
    <message>
        <source>Steeper than max_gradient: %1 of the container. No surface was met.</source>
        <translation>Más empinado que max_gradient: %1 del contenedor. No se encontró superficie.</translation>
    </message>
    <message>
        <source> Infinite at %1 samples.</source>
        <translation> Infinito en %1 muestras.</translation>
    </message>
</context>
<context>
    <name>isoscope::ImageExportDialog</name>
    <message>
        <source>Export image</source>
        <translation>Exportar imagen</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Width of the image</source>
        <translation>Anchura de la imagen</translation>
    </message>
    <message>
        <source>Height of the image</source>
        <translation>Altura de la imagen</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Keep the proportions</source>
        <translation>Mantener las proporciones</translation>
    </message>
    <message>
        <source>Width and height follow each other, so that the picture shows what the window shows</source>
        <translation>Anchura y altura se siguen, de modo que la imagen muestre lo que muestra la ventana</translation>
    </message>
    <message>
        <source>Smooth edges (anti-aliasing)</source>
        <translation>Bordes suaves (suavizado)</translation>
    </message>
    <message>
        <source>Several rays for pixels on edges; takes longer</source>
        <translation>Varios rayos para los píxeles de los bordes; tarda más</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>Fondo transparente</translation>
    </message>
    <message>
        <source>Leave out background and sky where no object hides them; the file says how much shows through</source>
        <translation>Omitir fondo y cielo donde ningún objeto los tapa; el archivo dice cuánto se transparenta</translation>
    </message>
    <message>
        <source>The file to write: .png for an image, .exr for OpenEXR with layers</source>
        <translation>El archivo que se escribe: .png para una imagen, .exr para OpenEXR con capas</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>Elegir el archivo</translation>
    </message>
    <message>
        <source>PNG, 8 bits a channel</source>
        <translation>PNG, 8 bits por canal</translation>
    </message>
    <message>
        <source>PNG, 16 bits a channel</source>
        <translation>PNG, 16 bits por canal</translation>
    </message>
    <message>
        <source>16 bits keep steps of light that 8 bits round away, in files of twice the size</source>
        <translation>16 bits conservan grados de luz que 8 bits redondean, en archivos el doble de grandes</translation>
    </message>
    <message>
        <source>OpenEXR: colour, opacity, distance, normals, verdicts</source>
        <translation>OpenEXR: color, opacidad, distancia, normales, veredictos</translation>
    </message>
    <message>
        <source>Channels R, G, B, A; Z; N.X, N.Y, N.Z; verdict, with the exact root finder</source>
        <translation>Canales R, G, B, A; Z; N.X, N.Y, N.Z; veredicto, con el buscador de raíces exacto</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>Render</source>
        <translation>Calcular</translation>
    </message>
    <message>
        <source>Render the image and write it</source>
        <translation>Calcular la imagen y escribirla</translation>
    </message>
    <message>
        <source>Queue</source>
        <translation>A la cola</translation>
    </message>
    <message>
        <source>Render the image behind those that are waiting; it goes on when this is closed</source>
        <translation>Calcular la imagen después de las que esperan; sigue aunque se cierre esto</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Stop; no file is written</source>
        <translation>Detener; no se escribe ningún archivo</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close; an export that is waited for is stopped</source>
        <translation>Cerrar; se detiene la exportación que se espera</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Open the image in the program for images</source>
        <translation>Abrir la imagen en el programa de imágenes</translation>
    </message>
    <message>
        <source>Show Folder</source>
        <translation>Mostrar carpeta</translation>
    </message>
    <message>
        <source>Open the folder that holds the image</source>
        <translation>Abrir la carpeta que contiene la imagen</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
    </message>
    <message>
        <source>%1 exists already. Replace it?</source>
        <translation>%1 ya existe. ¿Reemplazarlo?</translation>
    </message>
    <message>
        <source>PNG images (*.png)</source>
        <translation>Imágenes PNG (*.png)</translation>
    </message>
    <message>
        <source>OpenEXR images (*.exr)</source>
        <translation>Imágenes OpenEXR (*.exr)</translation>
    </message>
    <message>
        <source>Please choose a file.</source>
        <translation>Elija un archivo.</translation>
    </message>
    <message>
        <source>The file exists and is no PNG or OpenEXR picture: it is not replaced.</source>
        <translation>El archivo existe y no es una imagen PNG ni OpenEXR: no se reemplaza.</translation>
    </message>
    <message>
        <source>%1 is in the queue. Pictures on the way: %2</source>
        <translation>%1 está en la cola. Imágenes en curso: %2</translation>
    </message>
    <message>
        <source>Waits for other pictures…</source>
        <translation>Espera a otras imágenes…</translation>
    </message>
    <message>
        <source>Rendering…</source>
        <translation>Calculando…</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Escrito: %1</translation>
    </message>
    <message>
        <source>How long the picture will take with all cores of this computer: squares of it are drawn to find out. POV-Ray&apos;s time follows from the function and what its method evaluates.</source>
        <translation>Cuánto tardará la imagen con todos los núcleos de este ordenador: se dibujan cuadrados de ella para averiguarlo. El tiempo de POV-Ray se deduce de la función y de lo que evalúa su método.</translation>
    </message>
    <message>
        <source>How long the picture will take</source>
        <translation>Cuánto tardará la imagen</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
</context>
<context>
    <name>isoscope::IncludeFoldersDialog</name>
    <message>
        <source>Include folders</source>
        <translation>Carpetas de inclusión</translation>
    </message>
    <message>
        <source>#include looks beside the scene first, then in these folders, from the top, then in those of an installed POV-Ray.</source>
        <translation>#include busca primero junto a la escena, luego en estas carpetas, desde arriba, y luego en las de un POV-Ray instalado.</translation>
    </message>
    <message>
        <source>Folders in the order in which they are searched; drag to change it</source>
        <translation>Carpetas en el orden en que se busca; arrastrar para cambiarlo</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Añadir…</translation>
    </message>
    <message>
        <source>Add a folder</source>
        <translation>Añadir una carpeta</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Remove the selected folder from the list</source>
        <translation>Quitar de la lista la carpeta seleccionada</translation>
    </message>
    <message>
        <source>Use these folders</source>
        <translation>Usar estas carpetas</translation>
    </message>
    <message>
        <source>Leave the folders as they were</source>
        <translation>Dejar las carpetas como estaban</translation>
    </message>
    <message>
        <source>Add an include folder</source>
        <translation>Añadir una carpeta de inclusión</translation>
    </message>
</context>
<context>
    <name>isoscope::IncludeViewer</name>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close the include file (Esc)</source>
        <translation>Cerrar el archivo de inclusión (Esc)</translation>
    </message>
    <message>
        <source>Close the include file</source>
        <translation>Cerrar el archivo de inclusión</translation>
    </message>
    <message>
        <source>Include file, read only</source>
        <translation>Archivo de inclusión, solo lectura</translation>
    </message>
    <message>
        <source>%1 – read only</source>
        <translation>%1 – solo lectura</translation>
    </message>
</context>
<context>
    <name>isoscope::InsertionController</name>
    <message>
        <source>VirtuaLight&apos;s notation does not know POV-Ray&apos;s functions.</source>
        <translation>La notación de VirtuaLight no conoce las funciones de POV-Ray.</translation>
    </message>
</context>
<context>
    <name>isoscope::KeptTextsWindow</name>
    <message>
        <source>Kept texts</source>
        <translation>Textos conservados</translation>
    </message>
    <message>
        <source>First lines of the text</source>
        <translation>Primeras líneas del texto</translation>
    </message>
    <message>
        <source>Bring Back</source>
        <translation>Recuperar</translation>
    </message>
    <message>
        <source>Show this text in the editor</source>
        <translation>Mostrar este texto en el editor</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Delete this text for good</source>
        <translation>Borrar este texto para siempre</translation>
    </message>
    <message>
        <source>Discard All</source>
        <translation>Descartar todo</translation>
    </message>
    <message>
        <source>Delete all kept texts for good</source>
        <translation>Borrar para siempre todos los textos conservados</translation>
    </message>
    <message>
        <source>Discard All %1 for Good</source>
        <translation>Descartar los %1 para siempre</translation>
    </message>
    <message>
        <source>There are no kept texts.</source>
        <translation>No hay textos conservados.</translation>
    </message>
    <message>
        <source>Texts that were never saved. Each stays here until it is saved or discarded, for %1 days at least.</source>
        <translation>Textos que nunca se guardaron. Cada uno queda aquí hasta que se guarde o se descarte, %1 días como mínimo.</translation>
    </message>
    <message>
        <source>Never had a file</source>
        <translation>Nunca tuvo archivo</translation>
    </message>
</context>
<context>
    <name>isoscope::LinkedProbe</name>
    <message>
        <source>undefined</source>
        <translation>sin definir</translation>
    </message>
    <message>
        <source>infinite</source>
        <translation>infinito</translation>
    </message>
    <message>
        <source>x %1, y %2, z %3: %4</source>
        <translation>x %1, y %2, z %3: %4</translation>
    </message>
    <message>
        <source>f is undefined</source>
        <translation>f no está definida</translation>
    </message>
    <message>
        <source>f %1, |∇f| %2</source>
        <translation>f %1, |∇f| %2</translation>
    </message>
    <message>
        <source>%1, distance %2</source>
        <translation>%1, distancia %2</translation>
    </message>
</context>
<context>
    <name>isoscope::MainWindow</name>
    <message>
        <source>Another window could not be opened.</source>
        <translation>No se pudo abrir otra ventana.</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source>&lt;p&gt;The text of the scene, in POV-Ray&apos;s language. The picture follows while you type; signs in the margin tell what is wrong and whether surfaces have holes.&lt;/p&gt;</source>
        <translation>&lt;p&gt;El texto de la escena, en el lenguaje de POV-Ray. La imagen lo sigue mientras escribe; señales en el margen dicen qué está mal y si hay superficies con huecos.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parámetros</translation>
    </message>
    <message>
        <source>&lt;p&gt;A slider for every number of the text that can be moved. Moving it writes the number.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Un deslizador para cada número del texto que se puede mover. Al moverlo se escribe el número.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Functions</source>
        <translation>Funciones</translation>
    </message>
    <message>
        <source>&lt;p&gt;The functions that can be inserted, with pictures.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Las funciones que se pueden insertar, con imágenes.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Problemas</translation>
    </message>
    <message>
        <source>&lt;p&gt;What is wrong with the text, what is not shown of it, and which isosurfaces have holes in POV-Ray. Click a line to go there; buttons mend what can be mended.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Qué está mal en el texto, qué no se muestra de él y qué isosuperficies tienen huecos en POV-Ray. Pulse una línea para ir allí; hay botones que arreglan lo que tiene arreglo.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Gallery</source>
        <translation>Galería</translation>
    </message>
    <message>
        <source>&lt;p&gt;Functions, examples, POV-Ray&apos;s snippets and your own scenes. A click opens one.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Funciones, ejemplos, fragmentos de POV-Ray y escenas propias. Un clic abre una.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Línea de tiempo</translation>
    </message>
    <message>
        <source>&lt;p&gt;The frames of an animation, and the keys of numbers and view that make them. All of it is kept in comments of the text.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Los fotogramas de una animación, y las claves de números y vista que los forman. Todo se guarda en comentarios del texto.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
    <message>
        <source>Place of the caret in the text</source>
        <translation>Lugar del cursor en el texto</translation>
    </message>
    <message>
        <source>Place of the caret</source>
        <translation>Lugar del cursor</translation>
    </message>
    <message>
        <source>Line %1, column %2</source>
        <translation>Línea %1, columna %2</translation>
    </message>
    <message>
        <source>The text is newer than the picture; saving or F5 shows it.</source>
        <translation>El texto es más nuevo que la imagen; guardar o F5 lo muestra.</translation>
    </message>
    <message>
        <source>The language changes at the next start.</source>
        <translation>El idioma cambia en el próximo inicio.</translation>
    </message>
    <message>
        <source>%1 – Isoscope</source>
        <translation>%1 – Isoscope</translation>
    </message>
    <message>
        <source>The point under the mouse in the picture, the cross-section or a chart, in the coordinates of its function, with f and its gradient</source>
        <translation>El punto bajo el ratón en la imagen, la sección o un gráfico, en las coordenadas de su función, con f y su gradiente</translation>
    </message>
    <message>
        <source>The probed point</source>
        <translation>El punto sondeado</translation>
    </message>
</context>
<context>
    <name>isoscope::MeshExportDialog</name>
    <message>
        <source>Export mesh</source>
        <translation>Exportar malla</translation>
    </message>
    <message>
        <source>The notation of the file; its ending follows</source>
        <translation>La notación del archivo; su extensión la sigue</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>a 500th of the container</source>
        <translation>un 500.º del contenedor</translation>
    </message>
    <message>
        <source>How far mesh and surface may be apart, in units of the scene</source>
        <translation>Cuánto pueden separarse malla y superficie, en unidades de la escena</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerancia</translation>
    </message>
    <message>
        <source>Colours of the texture</source>
        <translation>Colores de la textura</translation>
    </message>
    <message>
        <source>A colour for each vertex, where the format has colours</source>
        <translation>Un color por vértice, si el formato tiene colores</translation>
    </message>
    <message>
        <source>The file to write</source>
        <translation>El archivo que se escribe</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>Elegir el archivo</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Make the mesh and write it</source>
        <translation>Hacer la malla y escribirla</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Stop; no file is written</source>
        <translation>Detener; no se escribe ningún archivo</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close; a running export is stopped</source>
        <translation>Cerrar; se detiene una exportación en marcha</translation>
    </message>
    <message>
        <source>Show Folder</source>
        <translation>Mostrar carpeta</translation>
    </message>
    <message>
        <source>Open the folder that holds the mesh</source>
        <translation>Abrir la carpeta que contiene la malla</translation>
    </message>
    <message>
        <source>Meshes (*.stl *.3mf *.obj *.ply *.glb *.inc)</source>
        <translation>Mallas (*.stl *.3mf *.obj *.ply *.glb *.inc)</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
    </message>
    <message>
        <source>%1 exists already. Replace it?</source>
        <translation>%1 ya existe. ¿Reemplazarlo?</translation>
    </message>
    <message>
        <source>Please choose a file.</source>
        <translation>Elija un archivo.</translation>
    </message>
    <message>
        <source>The tolerance is a positive number, or empty.</source>
        <translation>La tolerancia es un número positivo, o nada.</translation>
    </message>
    <message>
        <source>The file exists and is no mesh of Isoscope: it is not replaced.</source>
        <translation>El archivo existe y no es una malla de Isoscope: no se reemplaza.</translation>
    </message>
    <message>
        <source>Looking for the surface…</source>
        <translation>Buscando la superficie…</translation>
    </message>
    <message>
        <source>Stopped; nothing was written.</source>
        <translation>Detenido; no se escribió nada.</translation>
    </message>
    <message>
        <source>No mesh: %1.</source>
        <translation>Sin malla: %1.</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Deteniendo…</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Escrito: %1</translation>
    </message>
</context>
<context>
    <name>isoscope::NoticeBar</name>
    <message>
        <source>Notice</source>
        <translation>Aviso</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Hide this line</source>
        <translation>Ocultar esta línea</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <comment>notices</comment>
        <translation>
            <numerusform>%n más</numerusform>
            <numerusform>%n más</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>isoscope::NumberPopup</name>
    <message>
        <source>Slider for the number at the caret</source>
        <translation>Deslizador para el número en el cursor</translation>
    </message>
    <message>
        <source>Enter keeps the number, Esc brings the first one back</source>
        <translation>Intro conserva el número, Esc recupera el primero</translation>
    </message>
</context>
<context>
    <name>isoscope::NumberTool</name>
    <message>
        <source>Slider for the number at the caret</source>
        <translation>Deslizador para el número en el cursor</translation>
    </message>
    <message>
        <source>Change this number with a slider</source>
        <translation>Cambiar este número con un deslizador</translation>
    </message>
    <message>
        <source>There is no number at the caret.</source>
        <translation>No hay número en el cursor.</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Número</translation>
    </message>
</context>
<context>
    <name>isoscope::OverlayBar</name>
    <message>
        <source>What the overlay shows</source>
        <translation>Lo que muestra la superposición</translation>
    </message>
    <message>
        <source>Counted in the pixels of this picture, with the settings of the text</source>
        <translation>Contado en los píxeles de esta imagen, con los ajustes del texto</translation>
    </message>
    <message>
        <source>Progress of the overlay</source>
        <translation>Progreso de la superposición</translation>
    </message>
    <message>
        <source>How much of the overlay is computed</source>
        <translation>Cuánto de la superposición está calculado</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Stop computing the overlay</source>
        <translation>Dejar de calcular la superposición</translation>
    </message>
</context>
<context>
    <name>isoscope::OverlayButton</name>
    <message>
        <source>What is laid over the picture: holes of POV-Ray&apos;s method, or the gradient</source>
        <translation>Lo que se superpone a la imagen: huecos del método de POV-Ray, o el gradiente</translation>
    </message>
    <message>
        <source>Overlay of the picture</source>
        <translation>Superposición de la imagen</translation>
    </message>
</context>
<context>
    <name>isoscope::ParameterBinding</name>
    <message>
        <source>Kept until the file is closed: the text can only keep it for the last number of a line</source>
        <translation>Se conserva hasta cerrar el archivo: el texto solo puede conservarlo para el último número de una línea</translation>
    </message>
</context>
<context>
    <name>isoscope::ParameterGroup</name>
    <message>
        <source>Show or hide the parameters of %1</source>
        <translation>Mostrar u ocultar los parámetros de %1</translation>
    </message>
</context>
<context>
    <name>isoscope::ParameterPanel</name>
    <message>
        <source>Filter parameters</source>
        <translation>Filtrar parámetros</translation>
    </message>
    <message>
        <source>Shows only parameters whose name or function contains these words</source>
        <translation>Muestra solo los parámetros cuyo nombre o función contiene estas palabras</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parámetros</translation>
    </message>
    <message>
        <source>Numbers of the scene. A double click on a name brings its first value back</source>
        <translation>Números de la escena. Doble clic en un nombre recupera su primer valor</translation>
    </message>
    <message>
        <source>Randomise</source>
        <translation>Al azar</translation>
    </message>
    <message>
        <source>Random values for the numbers listed here; locked ones, containers, accuracy and max_gradient stay</source>
        <translation>Valores al azar para los números de esta lista; los bloqueados, contenedores, accuracy y max_gradient no cambian</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Restablecer</translation>
    </message>
    <message>
        <source>Brings the first values of the numbers listed here back; locked ones stay</source>
        <translation>Recupera los primeros valores de los números de esta lista; los bloqueados no cambian</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Otros</translation>
    </message>
    <message>
        <source>, lines %1 to %2</source>
        <translation>, líneas %1 a %2</translation>
    </message>
    <message>
        <source>, line %1</source>
        <translation>, línea %1</translation>
    </message>
    <message>
        <source>Nothing to move yet.
Numbers of function calls, #declare, threshold, accuracy, max_gradient and contained_by appear here.</source>
        <translation>Aún nada que mover.
Aquí aparecen números de llamadas a funciones, #declare, threshold, accuracy, max_gradient y contained_by.</translation>
    </message>
    <message>
        <source>No parameter matches the filter.</source>
        <translation>Ningún parámetro coincide con el filtro.</translation>
    </message>
    <message numerus="yes">
        <source>%n more number(s) are not shown; drag them in the text with Ctrl.</source>
        <translation>
            <numerusform>No se muestra %n número más; arrástrelo en el texto con Ctrl.</numerusform>
            <numerusform>No se muestran %n números más; arrástrelos en el texto con Ctrl.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>isoscope::ParameterSlider</name>
    <message>
        <source>More</source>
        <translation>Más</translation>
    </message>
    <message>
        <source>Replace by number</source>
        <translation>Cambiar por un número</translation>
    </message>
    <message>
        <source>%1 (default)</source>
        <translation>%1 (usual)</translation>
    </message>
    <message>
        <source>%1 (x, y and z)</source>
        <translation>%1 (x, y y z)</translation>
    </message>
    <message>
        <source>%1 is the expression %2</source>
        <translation>%1 es la expresión %2</translation>
    </message>
    <message>
        <source>Expression of %1</source>
        <translation>Expresión de %1</translation>
    </message>
    <message>
        <source>Writes %1 in place of the expression, which gives it a slider</source>
        <translation>Escribe %1 en lugar de la expresión, lo que le da un deslizador</translation>
    </message>
    <message>
        <source>Replace the expression of %1 by a number</source>
        <translation>Cambiar la expresión de %1 por un número</translation>
    </message>
    <message>
        <source>%1 is not in the text; moving the slider writes it</source>
        <translation>%1 no está en el texto; mover el deslizador lo escribe</translation>
    </message>
    <message>
        <source>%1. Double-click: back to %2</source>
        <translation>%1. Doble clic: volver a %2</translation>
    </message>
    <message>
        <source>%1, from %2 to %3</source>
        <translation>%1, de %2 a %3</translation>
    </message>
    <message>
        <source>There can be a surface from %1 to %2, the green part; for no other value of the slider, all else as it is</source>
        <translation>Puede haber superficie de %1 a %2, la parte verde; con ningún otro valor del deslizador, si lo demás no cambia</translation>
    </message>
    <message>
        <source>There is no surface for any value of the slider, all else as it is</source>
        <translation>No hay superficie con ningún valor del deslizador, si lo demás no cambia</translation>
    </message>
    <message>
        <source>%1, slider</source>
        <translation>%1, deslizador</translation>
    </message>
    <message>
        <source>Value of %1</source>
        <translation>Valor de %1</translation>
    </message>
    <message>
        <source>Lower end of the slider. Double-click to change it</source>
        <translation>Extremo inferior del deslizador. Doble clic para cambiarlo</translation>
    </message>
    <message>
        <source>Upper end of the slider. Double-click to change it</source>
        <translation>Extremo superior del deslizador. Doble clic para cambiarlo</translation>
    </message>
    <message>
        <source>Lower end of %1</source>
        <translation>Extremo inferior de %1</translation>
    </message>
    <message>
        <source>Upper end of %1</source>
        <translation>Extremo superior de %1</translation>
    </message>
    <message>
        <source>Stop (Esc)</source>
        <translation>Detener (Esc)</translation>
    </message>
    <message>
        <source>Play: moves %1 by itself, until Esc or a touch of the slider</source>
        <translation>Reproducir: mueve %1 solo, hasta Esc o hasta tocar el deslizador</translation>
    </message>
    <message>
        <source>Stop %1</source>
        <translation>Detener %1</translation>
    </message>
    <message>
        <source>Play %1</source>
        <translation>Reproducir %1</translation>
    </message>
    <message>
        <source>%1 is locked. Click to move it again</source>
        <translation>%1 está bloqueado. Clic para volver a moverlo</translation>
    </message>
    <message>
        <source>Unlock %1</source>
        <translation>Desbloquear %1</translation>
    </message>
    <message>
        <source>Range, step, lock and more of %1</source>
        <translation>Intervalo, paso, bloqueo y más de %1</translation>
    </message>
    <message>
        <source>Menu of %1</source>
        <translation>Menú de %1</translation>
    </message>
    <message>
        <source>Back to %1</source>
        <translation>Volver a %1</translation>
    </message>
    <message>
        <source>The value that the text had when it was opened</source>
        <translation>El valor que tenía el texto al abrirse</translation>
    </message>
    <message>
        <source>Random value</source>
        <translation>Valor al azar</translation>
    </message>
    <message>
        <source>Any value of the slider</source>
        <translation>Cualquier valor del deslizador</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Bloqueado</translation>
    </message>
    <message>
        <source>The slider does not move, nor does a preset or Randomise move it</source>
        <translation>El deslizador no se mueve, y ni un preajuste ni Al azar lo mueven</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Reproducir</translation>
    </message>
    <message>
        <source>Set key at this frame</source>
        <translation>Poner clave en este fotograma</translation>
    </message>
    <message>
        <source>The timeline keeps the present value, in a comment of the text</source>
        <translation>La línea de tiempo conserva el valor actual, en un comentario del texto</translation>
    </message>
    <message>
        <source>Range, step and scale…</source>
        <translation>Intervalo, paso y escala…</translation>
    </message>
    <message>
        <source>How the slider moves; kept in the text, in a comment behind the number</source>
        <translation>Cómo se mueve el deslizador; se conserva en el texto, en un comentario tras el número</translation>
    </message>
    <message>
        <source>Usual range</source>
        <translation>Intervalo usual</translation>
    </message>
    <message>
        <source>Takes the comment about the slider out of the text</source>
        <translation>Quita del texto el comentario sobre el deslizador</translation>
    </message>
    <message>
        <source>Enter sets the end, Escape leaves it</source>
        <translation>Intro fija el extremo, Escape lo deja</translation>
    </message>
    <message>
        <source>Back and forth</source>
        <translation>Ida y vuelta</translation>
    </message>
    <message>
        <source>Turns round at each end</source>
        <translation>Se vuelve en cada extremo</translation>
    </message>
    <message>
        <source>Round and round</source>
        <translation>En círculo</translation>
    </message>
    <message>
        <source>Begins at the lower end again</source>
        <translation>Empieza de nuevo en el extremo inferior</translation>
    </message>
    <message>
        <source>Once</source>
        <translation>Una vez</translation>
    </message>
    <message>
        <source>Stops at the upper end</source>
        <translation>Se detiene en el extremo superior</translation>
    </message>
    <message>
        <source>%1 s from end to end</source>
        <translation>%1 s de extremo a extremo</translation>
    </message>
    <message>
        <source>How fast it plays</source>
        <translation>A qué velocidad se reproduce</translation>
    </message>
</context>
<context>
    <name>isoscope::PictureForecast</name>
    <message>
        <source>0.1 s or less</source>
        <translation>0.1 s o menos</translation>
    </message>
    <message>
        <source>Being measured…</source>
        <translation>Se está midiendo…</translation>
    </message>
    <message>
        <source>Here about %1 (±%2 %)</source>
        <translation>Aquí aprox. %1 (±%2 %)</translation>
    </message>
    <message>
        <source>, POV-Ray without smooth edges about %1 (±%2 %)</source>
        <translation>, POV-Ray sin bordes suaves aprox. %1 (±%2 %)</translation>
    </message>
    <message>
        <source>, POV-Ray about %1 (±%2 %)</source>
        <translation>, POV-Ray aprox. %1 (±%2 %)</translation>
    </message>
</context>
<context>
    <name>isoscope::PictureQueue</name>
    <message>
        <source>%1 could not be written: %2.</source>
        <translation>No se pudo escribir %1: %2.</translation>
    </message>
    <message>
        <source>Stopped; nothing was written.</source>
        <translation>Detenido; no se escribió nada.</translation>
    </message>
</context>
<context>
    <name>isoscope::PictureQueueWindow</name>
    <message>
        <source>Pictures in the making</source>
        <translation>Imágenes en curso</translation>
    </message>
    <message>
        <source>No picture is on the way. File ▸ Export ▸ Image… puts them here by its button “Queue”.</source>
        <translation>No hay ninguna imagen en curso. Archivo ▸ Exportar ▸ Imagen… las pone aquí con su botón «A la cola».</translation>
    </message>
    <message>
        <source>Stop All</source>
        <translation>Detener todas</translation>
    </message>
    <message>
        <source>Stop every picture that is not written yet</source>
        <translation>Detener toda imagen aún no escrita</translation>
    </message>
    <message>
        <source>Clear List</source>
        <translation>Vaciar lista</translation>
    </message>
    <message>
        <source>Take the pictures off the list that are written or stopped; files stay</source>
        <translation>Quitar de la lista las imágenes escritas o detenidas; los archivos se quedan</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close; pictures go on</source>
        <translation>Cerrar; las imágenes siguen</translation>
    </message>
    <message>
        <source>%1, %2 × %3</source>
        <translation>%1, %2 × %3</translation>
    </message>
    <message>
        <source>Progress of %1</source>
        <translation>Progreso de %1</translation>
    </message>
    <message>
        <source>Open %1 in the program for images</source>
        <translation>Abrir %1 en el programa de imágenes</translation>
    </message>
    <message>
        <source>Stop %1</source>
        <translation>Detener %1</translation>
    </message>
</context>
<context>
    <name>isoscope::PictureRoom</name>
    <message>
        <source>&amp;Fold the Panels Below</source>
        <translation>&amp;Plegar los paneles de abajo</translation>
    </message>
    <message>
        <source>Leave of the panels below the picture only their tabs; a click on a tab unfolds them</source>
        <translation>Dejar de los paneles bajo la imagen solo sus pestañas; un clic en una los despliega</translation>
    </message>
    <message>
        <source>Unfold the panels below</source>
        <translation>Desplegar los paneles de abajo</translation>
    </message>
    <message>
        <source>Fold the panels below</source>
        <translation>Plegar los paneles de abajo</translation>
    </message>
</context>
<context>
    <name>isoscope::PresetController</name>
    <message>
        <source>Presets</source>
        <translation>Preajustes</translation>
    </message>
    <message>
        <source>Presets: named sets of values, kept in the text</source>
        <translation>Preajustes: juegos de valores con nombre, conservados en el texto</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>Nombre del preajuste</translation>
    </message>
    <message>
        <source>Enter keeps the preset under this name, Esc leaves it</source>
        <translation>Intro conserva el preajuste con este nombre, Esc lo deja</translation>
    </message>
    <message>
        <source>Sets the numbers to those of this preset; locked ones stay</source>
        <translation>Pone los números en los de este preajuste; los bloqueados no cambian</translation>
    </message>
    <message>
        <source>New preset…</source>
        <translation>Preajuste nuevo…</translation>
    </message>
    <message>
        <source>Keeps the present values under a name, in a comment of the text</source>
        <translation>Conserva los valores actuales con un nombre, en un comentario del texto</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>Actualizar</translation>
    </message>
    <message>
        <source>The preset takes the present values</source>
        <translation>El preajuste toma los valores actuales</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Cambiar nombre</translation>
    </message>
    <message>
        <source>Another name for the preset</source>
        <translation>Otro nombre para el preajuste</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Borrar</translation>
    </message>
    <message>
        <source>Takes the preset out of the text</source>
        <translation>Quita el preajuste del texto</translation>
    </message>
    <message>
        <source>Preset “%1” is set.</source>
        <translation>Puesto el preajuste «%1».</translation>
    </message>
    <message>
        <source>Locked and left as they are: %1.</source>
        <translation>Bloqueados, sin cambios: %1.</translation>
    </message>
    <message>
        <source>Not in the text: %1.</source>
        <translation>No están en el texto: %1.</translation>
    </message>
    <message>
        <source>Preset %1</source>
        <translation>Preajuste %1</translation>
    </message>
    <message>
        <source>A preset needs a name.</source>
        <translation>Un preajuste necesita un nombre.</translation>
    </message>
    <message>
        <source>There is a preset “%1” already.</source>
        <translation>Ya hay un preajuste «%1».</translation>
    </message>
</context>
<context>
    <name>isoscope::PreviewLight</name>
    <message>
        <source>An object has no pigment: POV-Ray shows it black.</source>
        <translation>Un objeto no tiene pigment: POV-Ray lo muestra negro.</translation>
    </message>
    <message>
        <source>Light It in the Preview</source>
        <translation>Iluminarlo en la vista previa</translation>
    </message>
    <message>
        <source>Show it in grey here; the text, exports and POV-Ray&apos;s picture stay black</source>
        <translation>Mostrarlo gris aquí; el texto, las exportaciones y la imagen de POV-Ray quedan negros</translation>
    </message>
    <message>
        <source>Leave It Black</source>
        <translation>Dejarlo negro</translation>
    </message>
    <message>
        <source>Problems offers to add a pigment</source>
        <translation>Problemas ofrece añadir un pigment</translation>
    </message>
</context>
<context>
    <name>isoscope::ProblemsPanel</name>
    <message>
        <source>Error</source>
        <translation>Error</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Advertencia</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Omitido</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Mensaje</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lugar</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Problemas</translation>
    </message>
    <message>
        <source>What is wrong with the text, and what of it is not shown. Enter goes to the place</source>
        <translation>Qué está mal en el texto y qué no se muestra de él. Intro va al lugar</translation>
    </message>
    <message>
        <source>No problems. Everything in the text is shown.</source>
        <translation>Sin problemas. Se muestra todo lo del texto.</translation>
    </message>
    <message>
        <source>%1 (%2 times)</source>
        <translation>%1 (%2 veces)</translation>
    </message>
    <message>
        <source>Change the text so; Undo takes it back</source>
        <translation>Cambiar así el texto; Deshacer lo anula</translation>
    </message>
    <message>
        <source>Fix All %1</source>
        <translation>Arreglar los %1</translation>
    </message>
    <message>
        <source>Do the same for every problem of this kind, as one step</source>
        <translation>Hacer lo mismo con todos los problemas de este tipo, en un solo paso</translation>
    </message>
    <message>
        <source>Copy Message</source>
        <translation>Copiar mensaje</translation>
    </message>
    <message>
        <source>error</source>
        <translation>error</translation>
    </message>
    <message>
        <source>errors</source>
        <translation>errores</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>advertencia</translation>
    </message>
    <message>
        <source>warnings</source>
        <translation>advertencias</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>omitido</translation>
    </message>
    <message>
        <source>note</source>
        <translation>nota</translation>
    </message>
    <message>
        <source>notes</source>
        <translation>notas</translation>
    </message>
    <message>
        <source>Problems: %1</source>
        <translation>Problemas: %1</translation>
    </message>
</context>
<context>
    <name>isoscope::QuickFixer</name>
    <message>
        <source>The text has changed there.</source>
        <translation>El texto ha cambiado ahí.</translation>
    </message>
    <message>
        <source>: done.</source>
        <translation>: hecho.</translation>
    </message>
    <message>
        <source>%1 changes made.</source>
        <translation>%1 cambios hechos.</translation>
    </message>
</context>
<context>
    <name>isoscope::RayPanel</name>
    <message>
        <source>The isosurface that is shown along the ray.</source>
        <translation>La isosuperficie que se muestra a lo largo del rayo.</translation>
    </message>
    <message>
        <source>The one in front</source>
        <translation>La de delante</translation>
    </message>
    <message>
        <source>Cones</source>
        <translation>Conos</translation>
    </message>
    <message>
        <source>What POV-Ray trusts: from each of its samples, how soon a function no steeper than max_gradient could reach the threshold. Between two cones that do not meet it, it looks no closer.</source>
        <translation>En qué confía POV-Ray: desde cada muestra, lo pronto que una función no más empinada que max_gradient podría alcanzar el umbral. Entre dos conos que no lo tocan no mira más de cerca.</translation>
    </message>
    <message>
        <source>Show the cones of max_gradient</source>
        <translation>Mostrar los conos de max_gradient</translation>
    </message>
    <message>
        <source>Enclosures</source>
        <translation>Encierros</translation>
    </message>
    <message>
        <source>How the exact picture finds the surface: the pieces in which the certified root finder encloses the function.</source>
        <translation>Cómo halla la superficie la imagen exacta: los tramos en que el buscador de raíces certificado encierra la función.</translation>
    </message>
    <message>
        <source>Show the enclosures of the exact picture</source>
        <translation>Mostrar los encierros de la imagen exacta</translation>
    </message>
    <message>
        <source>Value under the mouse</source>
        <translation>Valor bajo el ratón</translation>
    </message>
    <message>
        <source>ray</source>
        <translation>rayo</translation>
    </message>
    <message>
        <source>The function along the ray</source>
        <translation>La función a lo largo del rayo</translation>
    </message>
    <message>
        <source>f − threshold along the ray; wheel to zoom, drag to shift, double-click for the whole ray</source>
        <translation>f − threshold a lo largo del rayo; rueda para ampliar, arrastrar para desplazar, doble clic para el rayo entero</translation>
    </message>
    <message>
        <source>What happens along the ray</source>
        <translation>Lo que ocurre a lo largo del rayo</translation>
    </message>
    <message>
        <source>The scene has no isosurface.</source>
        <translation>La escena no tiene isosuperficie.</translation>
    </message>
    <message>
        <source>Switch “Ray” on above the picture and click a pixel.</source>
        <translation>Active «Rayo» sobre la imagen y pulse un píxel.</translation>
    </message>
    <message>
        <source>This ray passes the container by.</source>
        <translation>Este rayo no toca el contenedor.</translation>
    </message>
    <message>
        <source>f − threshold along the ray</source>
        <translation>f − threshold a lo largo del rayo</translation>
    </message>
    <message>
        <source>f − threshold</source>
        <translation>f − threshold</translation>
    </message>
    <message>
        <source>distance from the camera</source>
        <translation>distancia a la cámara</translation>
    </message>
    <message>
        <source>surface %1</source>
        <translation>superficie %1</translation>
    </message>
    <message>
        <source>POV-Ray %1</source>
        <translation>POV-Ray %1</translation>
    </message>
    <message>
        <source>enclosure</source>
        <translation>encierro</translation>
    </message>
    <message>
        <source>POV-Ray&apos;s samples</source>
        <translation>muestras de POV-Ray</translation>
    </message>
    <message>
        <source>dismissed</source>
        <translation>descartado</translation>
    </message>
    <message>
        <source>dismissed wrongly</source>
        <translation>descartado por error</translation>
    </message>
    <message>
        <source>at %1: %2</source>
        <translation>en %1: %2</translation>
    </message>
    <message>
        <source>undefined</source>
        <translation>indefinida</translation>
    </message>
</context>
<context>
    <name>isoscope::ReadingBar</name>
    <message>
        <source>Progress of reading</source>
        <translation>Progreso de la lectura</translation>
    </message>
    <message>
        <source>Where in the text is being read; loops lead back</source>
        <translation>Por dónde va la lectura del texto; los bucles vuelven atrás</translation>
    </message>
    <message>
        <source>Place in the text</source>
        <translation>Lugar en el texto</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>End the reading of this text; what was shown before stays</source>
        <translation>Terminar la lectura de este texto; queda lo mostrado antes</translation>
    </message>
    <message>
        <source>Stop reading</source>
        <translation>Detener la lectura</translation>
    </message>
    <message>
        <source>Reading the text: %1 s, %2 steps</source>
        <translation>Leyendo el texto: %1 s, %2 pasos</translation>
    </message>
</context>
<context>
    <name>isoscope::RecentFiles</name>
    <message>
        <source>No files yet</source>
        <translation>Aún no hay archivos</translation>
    </message>
    <message>
        <source>Clear list</source>
        <translation>Vaciar lista</translation>
    </message>
    <message>
        <source>Forget these files; nothing is deleted</source>
        <translation>Olvidar estos archivos; no se borra nada</translation>
    </message>
</context>
<context>
    <name>isoscope::RecoveryStore</name>
    <message>
        <source>Unsaved text cannot be kept in %1: %2.</source>
        <translation>El texto sin guardar no se puede conservar en %1: %2.</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>no se puede crear la carpeta</translation>
    </message>
    <message>
        <source>its lock cannot be taken</source>
        <translation>no se puede tomar su bloqueo</translation>
    </message>
</context>
<context>
    <name>isoscope::RepairPanel</name>
    <message>
        <source>line %1</source>
        <translation>línea %1</translation>
    </message>
    <message>
        <source>%1, %2 times</source>
        <translation>%1, %2 veces</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>al menos %1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>%1 times as long</source>
        <translation>%1 veces más</translation>
    </message>
    <message>
        <source>Isosurface</source>
        <translation>Isosuperficie</translation>
    </message>
    <message>
        <source>Proven</source>
        <translation>Demostrado</translation>
    </message>
    <message>
        <source>To write</source>
        <translation>A escribir</translation>
    </message>
    <message>
        <source>Wrong pixels</source>
        <translation>Píxeles erróneos</translation>
    </message>
    <message>
        <source>POV-Ray takes</source>
        <translation>POV-Ray tarda</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredicto</translation>
    </message>
    <message>
        <source>Isosurfaces of the scene and its include files</source>
        <translation>Isosuperficies de la escena y de sus archivos include</translation>
    </message>
    <message>
        <source>What is ticked is written by the button below; a double click, or Enter, shows the place</source>
        <translation>Lo marcado se escribe con el botón de abajo; un doble clic, o Intro, muestra el lugar</translation>
    </message>
    <message>
        <source>include_file.inc:1000, 100 times_____</source>
        <translation>include_file.inc:1000, 100 veces_____</translation>
    </message>
    <message>
        <source>How far the isosurfaces are judged</source>
        <translation>Hasta dónde están juzgadas las isosuperficies</translation>
    </message>
    <message>
        <source>Progress of the proofs</source>
        <translation>Progreso de las demostraciones</translation>
    </message>
    <message>
        <source>How many isosurfaces are judged</source>
        <translation>Cuántas isosuperficies están juzgadas</translation>
    </message>
    <message>
        <source>Stop the proofs or go on</source>
        <translation>Detener las demostraciones o continuar</translation>
    </message>
    <message>
        <source>Tick all or none</source>
        <translation>Marcar todo o nada</translation>
    </message>
    <message>
        <source>Writes what is ticked where it stands: into the text, where Undo takes it back, and into the include files in the folder of the scene; every other character stays</source>
        <translation>Escribe lo marcado en su sitio: en el texto, donde Deshacer lo revierte, y en los archivos include de la carpeta de la escena; todos los demás caracteres se conservan</translation>
    </message>
    <message>
        <source>Write the ticked values</source>
        <translation>Escribir los valores marcados</translation>
    </message>
    <message>
        <source>The file is not changed: %1.</source>
        <translation>El archivo no se cambia: %1.</translation>
    </message>
    <message>
        <source>The value cannot be written where the statement stands.</source>
        <translation>El valor no se puede escribir donde está la sentencia.</translation>
    </message>
    <message>
        <source>Go On</source>
        <translation>Continuar</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Go on with the proofs</source>
        <translation>Continuar con las demostraciones</translation>
    </message>
    <message>
        <source>End the proofs; what is known stays</source>
        <translation>Terminar las demostraciones; lo conocido se conserva</translation>
    </message>
    <message>
        <source>The isosurfaces are being judged…</source>
        <translation>Se están juzgando las isosuperficies…</translation>
    </message>
    <message>
        <source>The scene shows no isosurface that has a max_gradient.</source>
        <translation>La escena no muestra ninguna isosuperficie que tenga max_gradient.</translation>
    </message>
    <message>
        <source>%1 of %2 statements are judged.</source>
        <translation>%1 de %2 sentencias están juzgadas.</translation>
    </message>
    <message>
        <source>There is nothing to repair.</source>
        <translation>No hay nada que reparar.</translation>
    </message>
    <message>
        <source>Wrong pixels and time are those of this view; what is written is proven for every view.</source>
        <translation>Los píxeles erróneos y el tiempo son los de esta vista; lo que se escribe está demostrado para cualquier vista.</translation>
    </message>
    <message>
        <source>Tick All</source>
        <translation>Marcar todo</translation>
    </message>
    <message>
        <source>Tick None</source>
        <translation>Desmarcar todo</translation>
    </message>
    <message>
        <source>Ticks all rows that can be written, or none</source>
        <translation>Marca todas las filas que se pueden escribir, o ninguna</translation>
    </message>
    <message>
        <source>Write 1 Value</source>
        <translation>Escribir 1 valor</translation>
    </message>
    <message>
        <source>Write %1 Values</source>
        <translation>Escribir %1 valores</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Escribir</translation>
    </message>
</context>
<context>
    <name>isoscope::ReportPanel</name>
    <message>
        <source>no value</source>
        <translation>sin valor</translation>
    </message>
    <message>
        <source>infinite, or infinitely steep</source>
        <translation>infinita o infinitamente empinada</translation>
    </message>
    <message>
        <source>jumps by %1</source>
        <translation>salta en %1</translation>
    </message>
    <message>
        <source>jumps</source>
        <translation>salta</translation>
    </message>
    <message>
        <source>digits lost: off by up to %1</source>
        <translation>pérdida de cifras: error de hasta %1</translation>
    </message>
    <message>
        <source>kink</source>
        <translation>pliegue</translation>
    </message>
    <message>
        <source>The isosurface that is reported on.</source>
        <translation>La isosuperficie de la que se informa.</translation>
    </message>
    <message>
        <source>Report on the shape</source>
        <translation>Informe sobre la forma</translation>
    </message>
    <message>
        <source>What the solid is like, each with its proof or its error</source>
        <translation>Cómo es el sólido, cada dato con su demostración o su error</translation>
    </message>
    <message>
        <source>What the chosen place does to the pictures</source>
        <translation>Lo que el lugar elegido hace en las imágenes</translation>
    </message>
    <message>
        <source>Progress of the report</source>
        <translation>Progreso del informe</translation>
    </message>
    <message>
        <source>How much of the report is done</source>
        <translation>Cuánto del informe está hecho</translation>
    </message>
    <message>
        <source>Report or stop</source>
        <translation>Informar o detener</translation>
    </message>
    <message>
        <source>The function has</source>
        <translation>La función tiene</translation>
    </message>
    <message>
        <source>From the surface</source>
        <translation>De la superficie</translation>
    </message>
    <message>
        <source>Certainty</source>
        <translation>Certeza</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Dónde</translation>
    </message>
    <message>
        <source>Places where the function is not healthy</source>
        <translation>Lugares donde la función no está sana</translation>
    </message>
    <message>
        <source>Go There</source>
        <translation>Ir allí</translation>
    </message>
    <message>
        <source>Shows the place in the picture.</source>
        <translation>Muestra el lugar en la imagen.</translation>
    </message>
    <message>
        <source>Show the chosen place in the picture</source>
        <translation>Mostrar en la imagen el lugar elegido</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Informe</translation>
    </message>
    <message>
        <source>End the work</source>
        <translation>Terminar el trabajo</translation>
    </message>
    <message>
        <source>Find out what the isosurface is like</source>
        <translation>Averiguar cómo es la isosuperficie</translation>
    </message>
    <message>
        <source>The scene has no isosurface.</source>
        <translation>La escena no tiene isosuperficie.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Being found out…</source>
        <translation>Averiguando…</translation>
    </message>
    <message>
        <source>It is found out once nothing moves.</source>
        <translation>Se averigua en cuanto nada se mueve.</translation>
    </message>
    <message>
        <source>at the surface</source>
        <translation>en la superficie</translation>
    </message>
    <message>
        <source>%1 away</source>
        <translation>a %1</translation>
    </message>
    <message>
        <source>met</source>
        <translation>hallado</translation>
    </message>
    <message>
        <source>suspected</source>
        <translation>sospechado</translation>
    </message>
    <message>
        <source>The function has a value and a slope everywhere in the container, and no kink.</source>
        <translation>La función tiene valor y pendiente en todo el contenedor, y ningún pliegue.</translation>
    </message>
    <message>
        <source>Choose a place to see it, and what it does to the pictures.</source>
        <translation>Elija un lugar para verlo, y lo que hace en las imágenes.</translation>
    </message>
    <message>
        <source>Choose a place to see it. The search ended early: there may be more.</source>
        <translation>Elija un lugar para verlo. La búsqueda terminó antes de tiempo: puede haber más.</translation>
    </message>
    <message>
        <source>Remedy</source>
        <translation>Remedio</translation>
    </message>
    <message>
        <source>A click, or Enter, shows the place in the picture; a click on a remedy writes it</source>
        <translation>Un clic, o Intro, muestra el lugar en la imagen; un clic en un remedio lo escribe</translation>
    </message>
    <message>
        <source>Rewrite</source>
        <translation>Reescribir</translation>
    </message>
    <message>
        <source>Changes the text so; Undo takes it back.</source>
        <translation>Cambia así el texto; Deshacer lo revierte.</translation>
    </message>
    <message>
        <source>Write the remedy of the chosen place into the text</source>
        <translation>Escribir en el texto el remedio del lugar elegido</translation>
    </message>
    <message>
        <source>A click writes it: %1</source>
        <translation>Un clic lo escribe: %1</translation>
    </message>
</context>
<context>
    <name>isoscope::SceneDisplay</name>
    <message>
        <source>The text has errors; what was understood of it is shown.</source>
        <translation>El texto tiene errores; se muestra lo que se entendió.</translation>
    </message>
    <message>
        <source>The text has errors; the first picture, of the text before them, is under way.</source>
        <translation>El texto tiene errores; la primera imagen, del texto anterior a ellos, está en curso.</translation>
    </message>
    <message>
        <source>The text has errors; this is the picture from before.</source>
        <translation>El texto tiene errores; esta es la imagen de antes.</translation>
    </message>
    <message>
        <source>The text has errors, listed under Problems; nothing can be shown yet.</source>
        <translation>El texto tiene errores, listados en Problemas; aún no se puede mostrar nada.</translation>
    </message>
</context>
<context>
    <name>isoscope::SceneEditor</name>
    <message>
        <source>Scene text</source>
        <translation>Texto de la escena</translation>
    </message>
    <message>
        <source>The scene in POV-Ray&apos;s language. Ctrl with the up and down keys changes the number at the caret.</source>
        <translation>La escena en el lenguaje de POV-Ray. Ctrl con las flechas arriba y abajo cambia el número en el cursor.</translation>
    </message>
    <message>
        <source>The scene&apos;s text. Drag a number with Ctrl to change it.</source>
        <translation>El texto de la escena. Arrastre un número con Ctrl para cambiarlo.</translation>
    </message>
    <message>
        <source>Drag with Ctrl changes the number, a click with Ctrl opens a slider for it</source>
        <translation>Arrastrar con Ctrl cambia el número, un clic con Ctrl abre un deslizador para él</translation>
    </message>
</context>
<context>
    <name>isoscope::SceneLexer</name>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Comentario</translation>
    </message>
    <message>
        <source>String</source>
        <translation>Cadena</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Número</translation>
    </message>
    <message>
        <source>Directive</source>
        <translation>Directiva</translation>
    </message>
    <message>
        <source>Keyword</source>
        <translation>Palabra clave</translation>
    </message>
    <message>
        <source>Function</source>
        <translation>Función</translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation>Símbolo</translation>
    </message>
</context>
<context>
    <name>isoscope::SceneRepairer</name>
    <message>
        <source>The text is still being read; nothing is changed.</source>
        <translation>El texto aún se está leyendo; no se cambia nada.</translation>
    </message>
    <message>
        <source>%1 is not changed: %2.</source>
        <translation>%1 no se cambia: %2.</translation>
    </message>
    <message>
        <source>Values of max_gradient were written into %1.</source>
        <translation>Se han escrito valores de max_gradient en %1.</translation>
    </message>
    <message>
        <source>Put Back</source>
        <translation>Restituir</translation>
    </message>
    <message>
        <source>Give the files the text that they had</source>
        <translation>Devolver a los archivos el texto que tenían</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Keep the files as they are now</source>
        <translation>Dejar los archivos como están ahora</translation>
    </message>
    <message>
        <source>Not put back, for it has changed since or cannot be written: %1.</source>
        <translation>No se ha restituido, porque ha cambiado desde entonces o no se puede escribir: %1.</translation>
    </message>
</context>
<context>
    <name>isoscope::SectionControls</name>
    <message>
        <source>The isosurface whose function is shown</source>
        <translation>La isosuperficie cuya función se muestra</translation>
    </message>
    <message>
        <source>Cut at a constant %1 (in the function&apos;s own coordinates)</source>
        <translation>Cortar con %1 constante (en las coordenadas de la función)</translation>
    </message>
    <message>
        <source>Plane across the %1 axis</source>
        <translation>Plano perpendicular al eje %1</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Libre</translation>
    </message>
    <message>
        <source>Cut by a plane of any direction: turn it by its angles, or drag it in the picture</source>
        <translation>Cortar con un plano de cualquier dirección: gírelo con sus ángulos o arrástrelo en la imagen</translation>
    </message>
    <message>
        <source>Free plane</source>
        <translation>Plano libre</translation>
    </message>
    <message>
        <source>Where the plane lies; the ends are the container&apos;s walls</source>
        <translation>Dónde está el plano; los extremos son las paredes del contenedor</translation>
    </message>
    <message>
        <source>Position of the plane</source>
        <translation>Posición del plano</translation>
    </message>
    <message>
        <source>Position of the plane as a number</source>
        <translation>Posición del plano como número</translation>
    </message>
    <message>
        <source>turn </source>
        <translation>giro </translation>
    </message>
    <message>
        <source>Heading: how far the plane is turned about y</source>
        <translation>Rumbo: cuánto gira el plano alrededor de y</translation>
    </message>
    <message>
        <source>Heading of the plane</source>
        <translation>Rumbo del plano</translation>
    </message>
    <message>
        <source>tilt </source>
        <translation>caída </translation>
    </message>
    <message>
        <source>Tilt: how far the plane leans back; at 90° it lies level</source>
        <translation>Caída: cuánto se inclina el plano hacia atrás; a 90° queda horizontal</translation>
    </message>
    <message>
        <source>Tilt of the plane</source>
        <translation>Caída del plano</translation>
    </message>
    <message>
        <source>f − threshold</source>
        <translation>f − threshold</translation>
    </message>
    <message>
        <source>|∇f|</source>
        <translation>|∇f|</translation>
    </message>
    <message>
        <source>Quantity that is shown</source>
        <translation>Magnitud que se muestra</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Líneas</translation>
    </message>
    <message>
        <source>Thin lines of equal value</source>
        <translation>Líneas finas de igual valor</translation>
    </message>
    <message>
        <source>Show lines of equal value</source>
        <translation>Mostrar líneas de igual valor</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Perfil</translation>
    </message>
    <message>
        <source>Chart the function along a line: drag in the section to draw one</source>
        <translation>Gráfico de la función a lo largo de una línea: arrastre en la sección para trazarla</translation>
    </message>
    <message>
        <source>Profile along a line</source>
        <translation>Perfil a lo largo de una línea</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Write the section, or its numbers, to a file</source>
        <translation>Escribir la sección, o sus números, en un archivo</translation>
    </message>
    <message>
        <source>Save the section or its numbers</source>
        <translation>Guardar la sección o sus números</translation>
    </message>
    <message>
        <source>&amp;Picture (PNG)…</source>
        <translation>I&amp;magen (PNG)…</translation>
    </message>
    <message>
        <source>&amp;Numbers (CSV)…</source>
        <translation>&amp;Números (CSV)…</translation>
    </message>
    <message>
        <source>P&amp;rofile</source>
        <translation>Pe&amp;rfil</translation>
    </message>
    <message>
        <source>The %1 of the plane</source>
        <translation>%1 del plano</translation>
    </message>
    <message>
        <source>Distance of the plane from the middle of the container</source>
        <translation>Distancia del plano al centro del contenedor</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>Value with the full colour</source>
        <translation>Valor con el color pleno</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>distancia</translation>
    </message>
    <message>
        <source>What the colours show: the function, how steep it is, or how far the surface is: (f − threshold) ÷ |∇f|, which is right near the surface</source>
        <translation>Lo que muestran los colores: la función, lo empinada que es, o lo lejos que está la superficie: (f − threshold) ÷ |∇f|, correcto cerca de la superficie</translation>
    </message>
    <message>
        <source>What has the full colour, and by whose parts lines are drawn: the values of the function, the slope or the distance; auto: most values, or max_gradient</source>
        <translation>Lo que tiene el color pleno, y según cuyas partes se trazan líneas: los valores de la función, la pendiente o la distancia; auto: la mayoría de los valores, o max_gradient</translation>
    </message>
</context>
<context>
    <name>isoscope::SectionPanel</name>
    <message>
        <source>Value of the function under the mouse</source>
        <translation>Valor de la función bajo el ratón</translation>
    </message>
    <message>
        <source>profile</source>
        <translation>perfil</translation>
    </message>
    <message>
        <source>The container has no finite extent.</source>
        <translation>El contenedor no tiene extensión finita.</translation>
    </message>
    <message>
        <source>The scene has no isosurface to cut.</source>
        <translation>La escena no tiene isosuperficie que cortar.</translation>
    </message>
    <message>
        <source>through %1 across %2</source>
        <translation>por %1 perpendicular a %2</translation>
    </message>
    <message>
        <source>at %1 = %2</source>
        <translation>en %1 = %2</translation>
    </message>
    <message>
        <source>|∇f| %1; up to %2 here, max_gradient is %3</source>
        <translation>|∇f| %1; hasta %2 aquí, max_gradient es %3</translation>
    </message>
    <message>
        <source>f − threshold %1</source>
        <translation>f − threshold %1</translation>
    </message>
    <message>
        <source>; hatched where f is undefined</source>
        <translation>; rayado donde f no está definida</translation>
    </message>
    <message>
        <source>undefined</source>
        <translation>indefinida</translation>
    </message>
    <message>
        <source>%1: f − threshold = %2</source>
        <translation>%1: f − threshold = %2</translation>
    </message>
    <message>
        <source>, |∇f| = %1</source>
        <translation>, |∇f| = %1</translation>
    </message>
    <message>
        <source>Save Section</source>
        <translation>Guardar sección</translation>
    </message>
    <message>
        <source>Save Numbers</source>
        <translation>Guardar números</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>Imágenes PNG (*.png)</translation>
    </message>
    <message>
        <source>CSV tables (*.csv)</source>
        <translation>Tablas CSV (*.csv)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Guardado: %1.</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>No se puede escribir %1.</translation>
    </message>
    <message>
        <source>f − threshold on the plane: blue is inside, orange outside, the bold line is the surface.
|∇f|: red where it is steeper than max_gradient.
distance: (f − threshold) ÷ |∇f|, how far the surface is, to first order.
Drag to move, wheel to zoom, double-click to see all. Hatched: f is undefined.</source>
        <translation>f − threshold en el plano: azul es dentro, naranja fuera, la línea gruesa es la superficie.
|∇f|: rojo donde es más empinada que max_gradient.
distancia: (f − threshold) ÷ |∇f|, lo lejos que está la superficie, en primer orden.
Arrastrar para mover, rueda para ampliar, doble clic para ver todo. Rayado: f no está definida.</translation>
    </message>
    <message>
        <source>distance to the surface %1</source>
        <translation>distancia a la superficie %1</translation>
    </message>
    <message>
        <source>, distance = %1</source>
        <translation>, distancia = %1</translation>
    </message>
</context>
<context>
    <name>isoscope::SectionProfile</name>
    <message>
        <source>The function along the line</source>
        <translation>La función a lo largo de la línea</translation>
    </message>
    <message>
        <source>The quantity of the colours along the line from A to B; the dashed lines are where it passes the threshold</source>
        <translation>La magnitud de los colores a lo largo de la línea de A a B; las líneas discontinuas son donde pasa el umbral</translation>
    </message>
    <message>
        <source>Value along the line under the mouse</source>
        <translation>Valor en la línea bajo el ratón</translation>
    </message>
    <message>
        <source>Draw a line in the section.</source>
        <translation>Trace una línea en la sección.</translation>
    </message>
    <message>
        <source>|∇f|</source>
        <translation>|∇f|</translation>
    </message>
    <message>
        <source>f − threshold</source>
        <translation>f − threshold</translation>
    </message>
    <message>
        <source>distance from A</source>
        <translation>distancia desde A</translation>
    </message>
    <message>
        <source>Along the line from A to B</source>
        <translation>A lo largo de la línea de A a B</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>de %1 a %2</translation>
    </message>
    <message>
        <source>undefined</source>
        <translation>indefinida</translation>
    </message>
    <message>
        <source>%1: f − threshold = %2, |∇f| = %3</source>
        <translation>%1: f − threshold = %2, |∇f| = %3</translation>
    </message>
    <message>
        <source>, distance = %1</source>
        <translation>, distancia = %1</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>distancia</translation>
    </message>
</context>
<context>
    <name>isoscope::SectionView</name>
    <message>
        <source>Cross-section of the function</source>
        <translation>Sección de la función</translation>
    </message>
    <message>
        <source>%1, %2 away</source>
        <translation>%1, a %2</translation>
    </message>
</context>
<context>
    <name>isoscope::SettingWriter</name>
    <message>
        <source>%1 values of max_gradient are changed.</source>
        <translation>Se cambian %1 valores de max_gradient.</translation>
    </message>
    <message>
        <source>The isosurface does not stand in the text itself; its %1 is not changed.</source>
        <translation>La isosuperficie no está en el propio texto; su %1 no se cambia.</translation>
    </message>
    <message>
        <source>%1 is %2 now.</source>
        <translation>%1 es %2 ahora.</translation>
    </message>
    <message>
        <source>The isosurface does not stand in the text itself; it is not changed.</source>
        <translation>La isosuperficie no está en el propio texto; no se cambia.</translation>
    </message>
    <message>
        <source>The isosurface has evaluate now.</source>
        <translation>La isosuperficie tiene ahora evaluate.</translation>
    </message>
</context>
<context>
    <name>isoscope::SheetPanel</name>
    <message>
        <source>Draw the sheet, or stop</source>
        <translation>Dibujar la lámina, o detener</translation>
    </message>
    <message>
        <source>Progress of the sheet</source>
        <translation>Progreso de la lámina</translation>
    </message>
    <message>
        <source>How many of the pictures are drawn</source>
        <translation>Cuántas de las imágenes están dibujadas</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Guardar…</translation>
    </message>
    <message>
        <source>Write the sheet to a PNG file</source>
        <translation>Escribir la lámina en un archivo PNG</translation>
    </message>
    <message>
        <source>Save the sheet</source>
        <translation>Guardar la lámina</translation>
    </message>
    <message>
        <source>Click a picture to set its values in the text</source>
        <translation>Haga clic en una imagen para fijar sus valores en el texto</translation>
    </message>
    <message>
        <source>Sheet of small pictures</source>
        <translation>Lámina de imágenes pequeñas</translation>
    </message>
    <message>
        <source>About the sheet</source>
        <translation>Sobre la lámina</translation>
    </message>
    <message>
        <source>down</source>
        <translation>vertical</translation>
    </message>
    <message>
        <source>across</source>
        <translation>horizontal</translation>
    </message>
    <message>
        <source>The number whose values go down, if there is to be a second one</source>
        <translation>El número cuyos valores van hacia abajo, si ha de haber un segundo</translation>
    </message>
    <message>
        <source>The number whose values go across</source>
        <translation>El número cuyos valores van en horizontal</translation>
    </message>
    <message>
        <source>from</source>
        <translation>desde</translation>
    </message>
    <message>
        <source>First value</source>
        <translation>Primer valor</translation>
    </message>
    <message>
        <source>to</source>
        <translation>hasta</translation>
    </message>
    <message>
        <source>Last value</source>
        <translation>Último valor</translation>
    </message>
    <message>
        <source>Number of values</source>
        <translation>Número de valores</translation>
    </message>
    <message>
        <source>How many values are drawn</source>
        <translation>Cuántos valores se dibujan</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>(no second number)</source>
        <translation>(sin segundo número)</translation>
    </message>
    <message>
        <source>The text is still being read, or has errors.</source>
        <translation>El texto aún se está leyendo, o tiene errores.</translation>
    </message>
    <message>
        <source>The sheet would be too large.</source>
        <translation>La lámina sería demasiado grande.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>sheet</source>
        <translation>lámina</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>Imágenes PNG (*.png)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 se ha guardado.</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>%1 no se puede escribir.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Dibujar</translation>
    </message>
    <message>
        <source>End the drawing; what is drawn stays</source>
        <translation>Terminar el dibujo; lo dibujado se queda</translation>
    </message>
    <message>
        <source>Draw the scene in small for each of the values</source>
        <translation>Dibujar la escena en pequeño para cada uno de los valores</translation>
    </message>
    <message>
        <source>Choose one number, or two, and press Draw.</source>
        <translation>Elija un número, o dos, y pulse Dibujar.</translation>
    </message>
    <message>
        <source>The scene has no number to vary.</source>
        <translation>La escena no tiene ningún número que variar.</translation>
    </message>
    <message>
        <source>Stopped early: %1 of %2 pictures.</source>
        <translation>Detenida antes de tiempo: %1 de %2 imágenes.</translation>
    </message>
    <message>
        <source>Click a picture to set its values in the text.</source>
        <translation>Haga clic en una imagen para fijar sus valores en el texto.</translation>
    </message>
    <message>
        <source> values</source>
        <translation> valores</translation>
    </message>
</context>
<context>
    <name>isoscope::ShortcutWindow</name>
    <message>
        <source>Keyboard and mouse</source>
        <translation>Teclado y ratón</translation>
    </message>
    <message>
        <source>Search commands and keys</source>
        <translation>Buscar comandos y teclas</translation>
    </message>
    <message>
        <source>Shows only lines that contain these words</source>
        <translation>Muestra solo las líneas que contienen estas palabras</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Comando</translation>
    </message>
    <message>
        <source>Keys or mouse</source>
        <translation>Teclas o ratón</translation>
    </message>
    <message>
        <source>Commands with their keys</source>
        <translation>Comandos con sus teclas</translation>
    </message>
    <message>
        <source>Enter or a double click goes to the field for the command&apos;s keys</source>
        <translation>Intro o un doble clic va al campo de las teclas del comando</translation>
    </message>
    <message>
        <source>Reset All</source>
        <translation>Restablecer todo</translation>
    </message>
    <message>
        <source>Give every command the keys that the program comes with</source>
        <translation>Dar a cada comando las teclas con que viene el programa</translation>
    </message>
    <message>
        <source>New keys</source>
        <translation>Teclas nuevas</translation>
    </message>
    <message>
        <source>Press the keys that shall call the command</source>
        <translation>Pulse las teclas que llamarán al comando</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Fijar</translation>
    </message>
    <message>
        <source>Give the command these keys</source>
        <translation>Dar estas teclas al comando</translation>
    </message>
    <message>
        <source>No Keys</source>
        <translation>Sin teclas</translation>
    </message>
    <message>
        <source>Take the command&apos;s keys away</source>
        <translation>Quitar las teclas del comando</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Restablecer</translation>
    </message>
    <message>
        <source>Give the command the keys that it came with</source>
        <translation>Dar al comando las teclas con que vino</translation>
    </message>
    <message>
        <source>What these keys would do</source>
        <translation>Lo que harían estas teclas</translation>
    </message>
    <message>
        <source>Keys of “%1”:</source>
        <translation>Teclas de «%1»:</translation>
    </message>
    <message>
        <source>Choose a command to change its keys.</source>
        <translation>Elija un comando para cambiar sus teclas.</translation>
    </message>
    <message>
        <source>“%1” has these keys now and would lose them.</source>
        <translation>«%1» tiene ahora estas teclas y las perdería.</translation>
    </message>
    <message>
        <source>These keys are free.</source>
        <translation>Estas teclas están libres.</translation>
    </message>
</context>
<context>
    <name>isoscope::SliderNotePopup</name>
    <message>
        <source>Range, step and scale of %1</source>
        <translation>Intervalo, paso y escala de %1</translation>
    </message>
    <message>
        <source>Enter sets the values, Esc leaves them as they are</source>
        <translation>Intro fija los valores, Esc los deja como están</translation>
    </message>
    <message>
        <source>&amp;From</source>
        <translation>&amp;Desde</translation>
    </message>
    <message>
        <source>Lower end of the slider</source>
        <translation>Extremo inferior del deslizador</translation>
    </message>
    <message>
        <source>&amp;To</source>
        <translation>&amp;Hasta</translation>
    </message>
    <message>
        <source>Upper end of the slider</source>
        <translation>Extremo superior del deslizador</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>&amp;Paso</translation>
    </message>
    <message>
        <source>How far apart values are; empty: as fine as the slider is</source>
        <translation>Distancia entre valores; vacío: tan fino como el deslizador</translation>
    </message>
    <message>
        <source>fine</source>
        <translation>fino</translation>
    </message>
    <message>
        <source>&amp;Decimals</source>
        <translation>D&amp;ecimales</translation>
    </message>
    <message>
        <source>Digits behind the point that are written; empty: as many as needed</source>
        <translation>Cifras tras el punto que se escriben; vacío: las necesarias</translation>
    </message>
    <message>
        <source>as needed</source>
        <translation>las necesarias</translation>
    </message>
    <message>
        <source>&amp;Logarithmic</source>
        <translation>&amp;Logarítmica</translation>
    </message>
    <message>
        <source>Equal ways multiply the number; the lower end must be above 0</source>
        <translation>Tramos iguales multiplican el número; el extremo inferior debe ser mayor que 0</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Fijar</translation>
    </message>
    <message>
        <source>Writes the values into the text, in a comment behind the number</source>
        <translation>Escribe los valores en el texto, en un comentario tras el número</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>From and To must be numbers.</source>
        <translation>Desde y Hasta deben ser números.</translation>
    </message>
    <message>
        <source>From must be less than To.</source>
        <translation>Desde debe ser menor que Hasta.</translation>
    </message>
    <message>
        <source>A logarithmic slider must begin above 0.</source>
        <translation>Un deslizador logarítmico debe empezar por encima de 0.</translation>
    </message>
    <message>
        <source>The step must be above 0 and fit between From and To.</source>
        <translation>El paso debe ser mayor que 0 y caber entre Desde y Hasta.</translation>
    </message>
    <message>
        <source>Decimals must be a whole number from 0 to %1.</source>
        <translation>Decimales debe ser un número entero de 0 a %1.</translation>
    </message>
</context>
<context>
    <name>isoscope::StartPage</name>
    <message>
        <source>Start page</source>
        <translation>Página de inicio</translation>
    </message>
    <message>
        <source>&lt;p&gt;Scenes to begin with. A click opens one; everything in it can be changed.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Escenas para empezar. Un clic abre una; todo en ella se puede cambiar.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Begin with a picture</source>
        <translation>Empezar con una imagen</translation>
    </message>
    <message>
        <source>Choose one: its text opens at the left, and every number in it becomes a slider.</source>
        <translation>Elija una: su texto se abre a la izquierda, y cada número suyo se vuelve un deslizador.</translation>
    </message>
    <message>
        <source>Show this page at each start</source>
        <translation>Mostrar esta página en cada inicio</translation>
    </message>
    <message>
        <source>Otherwise File, Start Page opens it</source>
        <translation>Si no, la abre Archivo, Página de inicio</translation>
    </message>
    <message>
        <source>New Scene</source>
        <translation>Escena nueva</translation>
    </message>
    <message>
        <source>Begin with an empty scene</source>
        <translation>Empezar con una escena vacía</translation>
    </message>
    <message>
        <source>Open File…</source>
        <translation>Abrir archivo…</translation>
    </message>
    <message>
        <source>Open a scene or include file</source>
        <translation>Abrir una escena o un archivo de inclusión</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lecciones</translation>
    </message>
    <message>
        <source>Read the short lessons about isosurfaces</source>
        <translation>Leer las lecciones breves sobre isosuperficies</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Go on with the scene that is open (Esc)</source>
        <translation>Seguir con la escena abierta (Esc)</translation>
    </message>
</context>
<context>
    <name>isoscope::StudyController</name>
    <message>
        <source>There are no two isosurfaces to compare.</source>
        <translation>No hay dos isosuperficies que comparar.</translation>
    </message>
    <message>
        <source>The difference surface, f kept less f now, is on the clipboard.</source>
        <translation>La superficie de diferencia, f conservada menos f actual, está en el portapapeles.</translation>
    </message>
</context>
<context>
    <name>isoscope::SurfaceChooser</name>
    <message>
        <source>Isosurface</source>
        <translation>Isosuperficie</translation>
    </message>
    <message>
        <source>Isosurface %1</source>
        <translation>Isosuperficie %1</translation>
    </message>
</context>
<context>
    <name>isoscope::SweepPanel</name>
    <message>
        <source>The number whose values are tried</source>
        <translation>El número cuyos valores se prueban</translation>
    </message>
    <message>
        <source>Number that is varied</source>
        <translation>Número que varía</translation>
    </message>
    <message>
        <source>from</source>
        <translation>de</translation>
    </message>
    <message>
        <source>First value</source>
        <translation>Primer valor</translation>
    </message>
    <message>
        <source>to</source>
        <translation>a</translation>
    </message>
    <message>
        <source>Last value</source>
        <translation>Último valor</translation>
    </message>
    <message>
        <source>Number of values</source>
        <translation>Número de valores</translation>
    </message>
    <message>
        <source>How many values are tried</source>
        <translation>Cuántos valores se prueban</translation>
    </message>
    <message>
        <source>Measure or stop</source>
        <translation>Medir o detener</translation>
    </message>
    <message>
        <source>Progress of the measurement</source>
        <translation>Progreso de la medición</translation>
    </message>
    <message>
        <source>How much of the measurement is done</source>
        <translation>Cuánto de la medición está hecho</translation>
    </message>
    <message>
        <source>About the measurement</source>
        <translation>Sobre la medición</translation>
    </message>
    <message>
        <source>sweep</source>
        <translation>barrido</translation>
    </message>
    <message>
        <source>Pieces, tunnels, hollows</source>
        <translation>Piezas, túneles, cavidades</translation>
    </message>
    <message>
        <source>Largest gradient</source>
        <translation>Gradiente máximo</translation>
    </message>
    <message>
        <source>What the right chart shows</source>
        <translation>Lo que muestra el gráfico derecho</translation>
    </message>
    <message>
        <source>Evaluations per pixel</source>
        <translation>Evaluaciones por píxel</translation>
    </message>
    <message>
        <source>Click to write a value into the text</source>
        <translation>Clic para escribir un valor en el texto</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Measure Again</source>
        <translation>Medir de nuevo</translation>
    </message>
    <message>
        <source>End the measurement; what is measured stays</source>
        <translation>Terminar la medición; lo medido se queda</translation>
    </message>
    <message>
        <source>Try the values of the number in small pictures</source>
        <translation>Probar los valores del número en imágenes pequeñas</translation>
    </message>
    <message>
        <source>It is measured as soon as nothing moves.</source>
        <translation>Se mide en cuanto nada se mueve.</translation>
    </message>
    <message>
        <source>The scene has no isosurface with a number to vary.</source>
        <translation>La escena no tiene isosuperficie con un número que variar.</translation>
    </message>
    <message>
        <source>POV-Ray</source>
        <translation>POV-Ray</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>exacto</translation>
    </message>
    <message>
        <source>attained</source>
        <translation>alcanzado</translation>
    </message>
    <message>
        <source>proven</source>
        <translation>demostrado</translation>
    </message>
    <message>
        <source>pieces</source>
        <translation>piezas</translation>
    </message>
    <message>
        <source>tunnels</source>
        <translation>túneles</translation>
    </message>
    <message>
        <source>hollows</source>
        <translation>cavidades</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>ahora %1</translation>
    </message>
    <message>
        <source>Chart of %1 over %2</source>
        <translation>Gráfico de %1 sobre %2</translation>
    </message>
    <message>
        <source>Measured before the last change of scene or view.</source>
        <translation>Medido antes del último cambio de escena o vista.</translation>
    </message>
    <message>
        <source>Stopped early.</source>
        <translation>Detenido antes de tiempo.</translation>
    </message>
    <message>
        <source>Evaluations of the camera&apos;s rays; pieces of a grid of %1 cells.</source>
        <translation>Evaluaciones de los rayos de la cámara; piezas de una cuadrícula de %1 celdas.</translation>
    </message>
    <message>
        <source>The scene cannot be read for %1 of the values.</source>
        <translation>La escena no se puede leer con %1 de los valores.</translation>
    </message>
    <message>
        <source> values</source>
        <translation> valores</translation>
    </message>
</context>
<context>
    <name>isoscope::ThresholdPanel</name>
    <message>
        <source>proven</source>
        <translation>demostrado</translation>
    </message>
    <message>
        <source>suspected: the search ended before</source>
        <translation>sospechado: la búsqueda terminó antes</translation>
    </message>
    <message>
        <source>suspected: at the container&apos;s wall</source>
        <translation>sospechado: en la pared del contenedor</translation>
    </message>
    <message>
        <source>suspected: the function is constant there</source>
        <translation>sospechado: la función es constante ahí</translation>
    </message>
    <message>
        <source>suspected: more than a point</source>
        <translation>sospechado: más que un punto</translation>
    </message>
    <message>
        <source>suspected: a kink</source>
        <translation>sospechado: un pliegue</translation>
    </message>
    <message>
        <source>suspected: no bound of the gradient</source>
        <translation>sospechado: sin cota del gradiente</translation>
    </message>
    <message>
        <source>; </source>
        <translation>; </translation>
    </message>
    <message>
        <source> (×%1)</source>
        <translation> (×%1)</translation>
    </message>
    <message>
        <source>The isosurface whose threshold is looked at.</source>
        <translation>La isosuperficie cuyo umbral se mira.</translation>
    </message>
    <message>
        <source>Histogram of the function</source>
        <translation>Histograma de la función</translation>
    </message>
    <message>
        <source>How much of the container has which value of the function. Drag to move the threshold; it sticks to the lines, at which the surface changes its form.</source>
        <translation>Qué parte del contenedor tiene cada valor de la función. Arrastre para mover el umbral; se pega a las líneas, en las que la superficie cambia de forma.</translation>
    </message>
    <message>
        <source>About the threshold</source>
        <translation>Sobre el umbral</translation>
    </message>
    <message>
        <source>Progress of the search</source>
        <translation>Progreso de la búsqueda</translation>
    </message>
    <message>
        <source>How much of the search for critical values is done</source>
        <translation>Cuánto de la búsqueda de valores críticos está hecho</translation>
    </message>
    <message>
        <source>Search or stop</source>
        <translation>Buscar o detener</translation>
    </message>
    <message>
        <source>threshold</source>
        <translation>umbral</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Umbral</translation>
    </message>
    <message>
        <source>What happens as it rises</source>
        <translation>Lo que ocurre al subir</translation>
    </message>
    <message>
        <source>Certainty</source>
        <translation>Certeza</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Dónde</translation>
    </message>
    <message>
        <source>Thresholds at which the surface changes its form</source>
        <translation>Umbrales en que la superficie cambia de forma</translation>
    </message>
    <message>
        <source>A double click, or Enter, sets the threshold</source>
        <translation>Un doble clic, o Intro, fija el umbral</translation>
    </message>
    <message>
        <source>two pieces join or a tunnel opens (×88)</source>
        <translation>dos piezas se unen o se abre un túnel (×88)</translation>
    </message>
    <message>
        <source>suspected: a kink_</source>
        <translation>sospechado: un pliegue_</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Usar</translation>
    </message>
    <message>
        <source>Go There</source>
        <translation>Ir allí</translation>
    </message>
    <message>
        <source>Writes this threshold into the text.</source>
        <translation>Escribe este umbral en el texto.</translation>
    </message>
    <message>
        <source>Use the chosen threshold</source>
        <translation>Usar el umbral elegido</translation>
    </message>
    <message>
        <source>Shows the place where it happens in the picture.</source>
        <translation>Muestra en la imagen el lugar donde ocurre.</translation>
    </message>
    <message>
        <source>Show the place of the chosen threshold</source>
        <translation>Mostrar el lugar del umbral elegido</translation>
    </message>
    <message>
        <source>The values of the function are shown here once nothing moves.</source>
        <translation>Los valores de la función se muestran aquí en cuanto nada se mueve.</translation>
    </message>
    <message>
        <source>The scene has no isosurface.</source>
        <translation>La escena no tiene isosuperficie.</translation>
    </message>
    <message>
        <source>Distribution of the function</source>
        <translation>Distribución de la función</translation>
    </message>
    <message>
        <source>in the container</source>
        <translation>en el contenedor</translation>
    </message>
    <message>
        <source>pieces or hollows appear, go</source>
        <translation>piezas o cavidades aparecen, se van</translation>
    </message>
    <message>
        <source>pieces join, tunnels</source>
        <translation>piezas se unen, túneles</translation>
    </message>
    <message>
        <source>suspected</source>
        <translation>sospechado</translation>
    </message>
    <message>
        <source>threshold %1</source>
        <translation>umbral %1</translation>
    </message>
    <message>
        <source>f</source>
        <translation>f</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>What happens as it falls</source>
        <translation>Lo que ocurre al bajar</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>End the search for critical values</source>
        <translation>Terminar la búsqueda de valores críticos</translation>
    </message>
    <message>
        <source>Search for the values at which the surface changes its form</source>
        <translation>Buscar los valores en que la superficie cambia de forma</translation>
    </message>
    <message>
        <source>%1 of the container is inside.</source>
        <translation>%1 del contenedor está dentro.</translation>
    </message>
    <message>
        <source>Values at which its form changes: %1 proven, %2 suspected, no others but at the container&apos;s wall.</source>
        <translation>Valores en que cambia su forma: %1 demostrados, %2 sospechados, ningún otro salvo en la pared del contenedor.</translation>
    </message>
    <message>
        <source>The first %1 are listed.</source>
        <translation>Se listan los primeros %1.</translation>
    </message>
    <message>
        <source>Where the function jumps there may be more.</source>
        <translation>Donde la función salta puede haber más.</translation>
    </message>
</context>
<context>
    <name>isoscope::TimelineController</name>
    <message>
        <source>Nothing differs from its keys at this frame.</source>
        <translation>Nada difiere de sus claves en este fotograma.</translation>
    </message>
</context>
<context>
    <name>isoscope::TimelinePanel</name>
    <message>
        <source>Timeline</source>
        <translation>Línea de tiempo</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>Primer fotograma</translation>
    </message>
    <message>
        <source>Go to the first frame</source>
        <translation>Ir al primer fotograma</translation>
    </message>
    <message>
        <source>Play the animation</source>
        <translation>Reproducir la animación</translation>
    </message>
    <message>
        <source>Play the frames in their time; Esc stops</source>
        <translation>Reproducir los fotogramas a su tiempo; Esc detiene</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Último fotograma</translation>
    </message>
    <message>
        <source>Go to the last frame</source>
        <translation>Ir al último fotograma</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Repetir</translation>
    </message>
    <message>
        <source>Begin anew at the last frame</source>
        <translation>Empezar de nuevo en el último fotograma</translation>
    </message>
    <message>
        <source>F&amp;rame</source>
        <translation>Foto&amp;grama</translation>
    </message>
    <message>
        <source>Present frame</source>
        <translation>Fotograma actual</translation>
    </message>
    <message>
        <source>The frame that is shown</source>
        <translation>El fotograma que se muestra</translation>
    </message>
    <message>
        <source>Set Key</source>
        <translation>Poner clave</translation>
    </message>
    <message>
        <source>Keep the present value of a number, or the view, at this frame; in the text</source>
        <translation>Conservar el valor actual de un número, o la vista, en este fotograma; en el texto</translation>
    </message>
    <message>
        <source>Remove key</source>
        <translation>Quitar clave</translation>
    </message>
    <message>
        <source>Take the key of the chosen row at this frame away (Delete)</source>
        <translation>Quitar la clave de la fila elegida en este fotograma (Supr)</translation>
    </message>
    <message>
        <source>Way to the next key</source>
        <translation>Camino a la clave siguiente</translation>
    </message>
    <message>
        <source>How the value goes from the key of the chosen row at this frame to its next one</source>
        <translation>Cómo va el valor de la clave de la fila elegida en este fotograma a la siguiente</translation>
    </message>
    <message>
        <source>Fra&amp;mes</source>
        <translation>Fotogra&amp;mas</translation>
    </message>
    <message>
        <source>First frame of the animation</source>
        <translation>Primer fotograma de la animación</translation>
    </message>
    <message>
        <source>Number of the first frame</source>
        <translation>Número del primer fotograma</translation>
    </message>
    <message>
        <source>to</source>
        <translation>a</translation>
    </message>
    <message>
        <source>Last frame of the animation</source>
        <translation>Último fotograma de la animación</translation>
    </message>
    <message>
        <source>Number of the last frame</source>
        <translation>Número del último fotograma</translation>
    </message>
    <message>
        <source>Frames per second</source>
        <translation>Fotogramas por segundo</translation>
    </message>
    <message>
        <source>How fast the animation plays</source>
        <translation>A qué velocidad se reproduce la animación</translation>
    </message>
    <message>
        <source>per second</source>
        <translation>por segundo</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Draw all frames into pictures, and a film where ffmpeg is installed</source>
        <translation>Dibujar todos los fotogramas en imágenes, y una película si ffmpeg está instalado</translation>
    </message>
    <message>
        <source>cl&amp;ock</source>
        <translation>cl&amp;ock</translation>
    </message>
    <message>
        <source>Clock of the first frame</source>
        <translation>Clock del primer fotograma</translation>
    </message>
    <message>
        <source>The value of clock in the first frame, for the text and for POV-Ray</source>
        <translation>El valor de clock en el primer fotograma, para el texto y para POV-Ray</translation>
    </message>
    <message>
        <source>Clock of the last frame</source>
        <translation>Clock del último fotograma</translation>
    </message>
    <message>
        <source>The value of clock in the last frame, for the text and for POV-Ray</source>
        <translation>El valor de clock en el último fotograma, para el texto y para POV-Ray</translation>
    </message>
    <message>
        <source>Stop the animation</source>
        <translation>Detener la animación</translation>
    </message>
    <message>
        <source>What differs from its keys</source>
        <translation>Lo que difiere de sus claves</translation>
    </message>
    <message>
        <source>A key for each number with keys, and for the view, that differs from them now</source>
        <translation>Una clave para cada número con claves, y para la vista, que ahora difiera de ellas</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>A key for the camera: the present view</source>
        <translation>Una clave para la cámara: la vista actual</translation>
    </message>
    <message>
        <source>A key for this number: its present value</source>
        <translation>Una clave para este número: su valor actual</translation>
    </message>
</context>
<context>
    <name>isoscope::TimelineView</name>
    <message>
        <source>Frames and keys</source>
        <translation>Fotogramas y claves</translation>
    </message>
    <message>
        <source>Drag to go to a frame, drag a key to move it; a right click on a key has more</source>
        <translation>Arrastrar para ir a un fotograma, arrastrar una clave para moverla; clic derecho en una clave para más</translation>
    </message>
    <message>
        <source>Frame %1 of %2 to %3</source>
        <translation>Fotograma %1 de %2 a %3</translation>
    </message>
    <message>
        <source>%1 has no key here</source>
        <translation>%1 no tiene clave aquí</translation>
    </message>
    <message>
        <source>%1 (not in the text)</source>
        <translation>%1 (no está en el texto)</translation>
    </message>
    <message>
        <source>No keys yet: go to a frame, move a slider or the view, and choose Set Key.</source>
        <translation>Aún no hay claves: vaya a un fotograma, mueva un deslizador o la vista y elija Poner clave.</translation>
    </message>
</context>
<context>
    <name>isoscope::VerdictBadge</name>
    <message>
        <source>isosurface in line %1</source>
        <translation>isosuperficie en la línea %1</translation>
    </message>
    <message>
        <source>isosurface %1</source>
        <translation>isosuperficie %1</translation>
    </message>
    <message>
        <source>no holes: proven</source>
        <translation>sin huecos: demostrado</translation>
    </message>
    <message>
        <source>holes: %1</source>
        <translation>huecos: %1</translation>
    </message>
    <message>
        <source>%1 × slower than need be</source>
        <translation>%1 × más lento de lo necesario</translation>
    </message>
    <message>
        <source>&lt;p&gt;Whether POV-Ray&apos;s picture of the isosurfaces of this text has holes, or takes longer than it has to. This is proven in the background, for every isosurface; the badge tells the worst.&lt;/p&gt;&lt;p&gt;POV-Ray&apos;s root finder trusts &lt;b&gt;max_gradient&lt;/b&gt;: where the function is steeper, it steps over the surface. Click to see the numbers in the panel “Gradient”.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Si la imagen de POV-Ray de las isosuperficies de este texto tiene huecos, o tarda más de lo necesario. Se demuestra en segundo plano, para cada isosuperficie; el distintivo dice la peor.&lt;/p&gt;&lt;p&gt;El buscador de raíces de POV-Ray confía en &lt;b&gt;max_gradient&lt;/b&gt;: donde la función es más empinada, se salta la superficie. Pulse para ver los números en el panel «Gradiente».&lt;/p&gt;</translation>
    </message>
    <message>
        <source> (%1 of %2)</source>
        <translation> (%1 de %2)</translation>
    </message>
    <message>
        <source>&lt;p&gt;%1 more.&lt;/p&gt;</source>
        <translation>&lt;p&gt;%1 más.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Verdict on max_gradient: %1</source>
        <translation>Veredicto sobre max_gradient: %1</translation>
    </message>
    <message>
        <source>Use %1: %2</source>
        <translation>Usar %1: %2</translation>
    </message>
    <message>
        <source>Fix All %1</source>
        <translation>Arreglar los %1</translation>
    </message>
    <message>
        <source>Still reading…</source>
        <translation>Leyendo aún…</translation>
    </message>
    <message>
        <source>The text is still being read; its isosurfaces are judged afterwards.</source>
        <translation>El texto aún se está leyendo; sus isosuperficies se juzgan después.</translation>
    </message>
    <message>
        <source>Verdict on max_gradient: the text is still being read</source>
        <translation>Veredicto sobre max_gradient: el texto aún se está leyendo</translation>
    </message>
</context>
<context>
    <name>isoscope::VerdictController</name>
    <message>
        <source>infinitely steep</source>
        <translation>infinitamente empinada</translation>
    </message>
    <message>
        <source>steepest: %1</source>
        <translation>lo más empinado: %1</translation>
    </message>
    <message>
        <source>No problems. Everything in the text is shown.</source>
        <translation>Sin problemas. Se muestra todo lo del texto.</translation>
    </message>
    <message>
        <source>The text is still being read.</source>
        <translation>El texto aún se está leyendo.</translation>
    </message>
    <message>
        <source>The text has no mistakes.</source>
        <translation>El texto no tiene errores.</translation>
    </message>
    <message>
        <source>No problems so far. Whether POV-Ray&apos;s picture has holes is being found out.</source>
        <translation>Sin problemas hasta ahora. Se averigua si la imagen de POV-Ray tiene huecos.</translation>
    </message>
    <message>
        <source>POV-Ray&apos;s picture has no holes: that is proven.</source>
        <translation>La imagen de POV-Ray no tiene huecos: está demostrado.</translation>
    </message>
</context>
<context>
    <name>isoscope::ViewController</name>
    <message>
        <source>There is nothing to fit: what the scene shows is empty, or has no end.</source>
        <translation>No hay nada que encuadrar: lo que muestra la escena está vacío o no tiene fin.</translation>
    </message>
</context>
<context>
    <name>isoscope::ViewOverlay</name>
    <message>
        <source>The pictures cannot be compared.</source>
        <translation>Las imágenes no se pueden comparar.</translation>
    </message>
    <message>
        <source>There is no text that POV-Ray could draw.</source>
        <translation>No hay texto que POV-Ray pueda dibujar.</translation>
    </message>
    <message>
        <source>POV-Ray draws the picture…</source>
        <translation>POV-Ray dibuja la imagen…</translation>
    </message>
    <message>
        <source>Measuring the gradient on the surface…</source>
        <translation>Midiendo el gradiente en la superficie…</translation>
    </message>
    <message>
        <source>Comparing POV-Ray&apos;s picture with the exact one…</source>
        <translation>Comparando la imagen de POV-Ray con la exacta…</translation>
    </message>
    <message>
        <source>Stopped. Redraw the picture to see it.</source>
        <translation>Detenido. Redibuje la imagen para verlo.</translation>
    </message>
    <message>
        <source>Waits for the picture.</source>
        <translation>Espera a la imagen.</translation>
    </message>
    <message>
        <source>Nothing is kept. Choose Compare again to keep the scene as it is.</source>
        <translation>No hay nada conservado. Elija de nuevo Comparar para conservar la escena como está.</translation>
    </message>
    <message>
        <source>Drawing the kept scene…</source>
        <translation>Dibujando la escena conservada…</translation>
    </message>
    <message>
        <source>Left of the divider the kept scene, right of it the present one</source>
        <translation>A la izquierda del divisor la escena conservada, a la derecha la actual</translation>
    </message>
    <message>
        <source>POV-Ray itself</source>
        <translation>el propio POV-Ray</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>exacto</translation>
    </message>
    <message>
        <source>A, kept</source>
        <translation>A, conservada</translation>
    </message>
    <message>
        <source>B, now</source>
        <translation>B, ahora</translation>
    </message>
    <message>
        <source>as POV-Ray</source>
        <translation>como POV-Ray</translation>
    </message>
    <message>
        <source>Counting what each pixel takes…</source>
        <translation>Contando lo que requiere cada píxel…</translation>
    </message>
</context>
<context>
    <name>isoscope::Viewport</name>
    <message>
        <source>Picture of the scene</source>
        <translation>Imagen de la escena</translation>
    </message>
    <message>
        <source>Arrow keys turn the view, Shift and arrow keys shift it, plus and minus zoom, Home resets; Alt and arrow keys move the divider of a split view</source>
        <translation>Las flechas giran la vista, Mayús y flechas la desplazan, más y menos amplían y reducen, Inicio restablece; Alt y flechas mueven el divisor de una vista dividida</translation>
    </message>
    <message>
        <source>Drag to turn, right-drag or Shift-drag to shift, wheel to zoom, double-click to reset, Ctrl-drag to take the picture elsewhere</source>
        <translation>Arrastrar para girar, con el botón derecho o Mayús para desplazar, rueda para ampliar, doble clic para restablecer, con Ctrl para llevar la imagen a otra parte</translation>
    </message>
    <message>
        <source>Nothing to see yet: the text has no object.
Type a formula, such as x*x + y*y + z*z - 1, or insert a function, to begin.</source>
        <translation>Aún nada que ver: el texto no tiene objetos.
Escriba una fórmula, como x*x + y*y + z*z - 1, o inserte una función para empezar.</translation>
    </message>
</context>
<context>
    <name>isoscope::ViewportPanel</name>
    <message>
        <source>View tools</source>
        <translation>Herramientas de vista</translation>
    </message>
    <message>
        <source>More tools</source>
        <translation>Más herramientas</translation>
    </message>
    <message>
        <source>State of the picture</source>
        <translation>Estado de la imagen</translation>
    </message>
    <message>
        <source>How far the picture is, and the time since it began.</source>
        <translation>Por dónde va la imagen, y el tiempo desde que empezó.</translation>
    </message>
    <message>
        <source>Cost of the picture</source>
        <translation>Coste de la imagen</translation>
    </message>
    <message>
        <source>How much of the picture is proven to be right, and what it cost. Exact pictures are proven pixel by pixel, by the certified root finder; the cost is told in rays and in evaluations of functions.</source>
        <translation>Cuánto de la imagen está demostrado correcto y lo que costó. Las imágenes exactas se demuestran píxel a píxel, con el buscador de raíces certificado; el coste se da en rayos y en evaluaciones de funciones.</translation>
    </message>
    <message>
        <source>No picture yet</source>
        <translation>Aún no hay imagen</translation>
    </message>
    <message>
        <source>Pass %1 of %2, %3 s</source>
        <translation>Pasada %1 de %2, %3 s</translation>
    </message>
    <message>
        <source>Stopped after pass %1 of %2, %3 s</source>
        <translation>Detenido tras la pasada %1 de %2, %3 s</translation>
    </message>
    <message>
        <source>Finished in %1 s, %2 × %3</source>
        <translation>Terminado en %1 s, %2 × %3</translation>
    </message>
    <message>
        <source>%1 rays, %2 evaluations</source>
        <translation>%1 rayos, %2 evaluaciones</translation>
    </message>
    <message>
        <source>Nothing was there to prove</source>
        <translation>No había nada que demostrar</translation>
    </message>
</context>
<context>
    <name>isoscope::VtkPanel</name>
    <message>
        <source>This panel cannot be drawn: %1.</source>
        <translation>Este panel no se puede dibujar: %1.</translation>
    </message>
</context>
<context>
    <name>isoscope::WhatsThis</name>
    <message>
        <source>&lt;p&gt;The level at which the surface lies: it is where the function has this value, and the solid is where the function is smaller.&lt;/p&gt;&lt;p&gt;&lt;b&gt;threshold&lt;/b&gt; is 0 where the text says nothing.&lt;/p&gt;</source>
        <translation>&lt;p&gt;El nivel en que está la superficie: es donde la función tiene este valor, y el sólido es donde la función es menor.&lt;/p&gt;&lt;p&gt;&lt;b&gt;threshold&lt;/b&gt; es 0 si el texto no dice nada.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;How closely the place of the surface is found. Smaller is finer and takes longer; sheets thinner than this may be missed.&lt;/p&gt;&lt;p&gt;POV-Ray ends its search along a ray when the interval is shorter than &lt;b&gt;accuracy&lt;/b&gt;.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Con qué precisión se halla el lugar de la superficie. Menor es más fino y tarda más; las hojas más delgadas pueden perderse.&lt;/p&gt;&lt;p&gt;POV-Ray termina su búsqueda en un rayo cuando el intervalo es más corto que &lt;b&gt;accuracy&lt;/b&gt;.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;How steep POV-Ray takes the function to be. Too low leaves holes in its picture, too high makes it slow; the badge in the status line tells which, with proof.&lt;/p&gt;&lt;p&gt;The gradient of the function must nowhere in the container be longer than &lt;b&gt;max_gradient&lt;/b&gt;.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Lo empinada que POV-Ray supone la función. Demasiado bajo deja huecos en su imagen, demasiado alto la hace lenta; el distintivo de la línea de estado dice cuál, con demostración.&lt;/p&gt;&lt;p&gt;El gradiente de la función no debe ser en ningún lugar del contenedor más largo que &lt;b&gt;max_gradient&lt;/b&gt;.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Shows the surface as it is, without holes.&lt;/p&gt;&lt;p&gt;The certified root finder encloses the function along every ray and proves what it finds; it needs no max_gradient. Pixels that could not be proven are counted below the picture.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Muestra la superficie tal como es, sin huecos.&lt;/p&gt;&lt;p&gt;El buscador de raíces certificado encierra la función en cada rayo y demuestra lo que halla; no necesita max_gradient. Los píxeles que no se pudieron demostrar se cuentan bajo la imagen.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Shows what POV-Ray will draw, holes included.&lt;/p&gt;&lt;p&gt;POV-Ray&apos;s root finder trusts max_gradient and accuracy of the text; where the function is steeper than max_gradient it may step over the surface.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Muestra lo que POV-Ray dibujará, con sus huecos.&lt;/p&gt;&lt;p&gt;El buscador de raíces de POV-Ray confía en max_gradient y accuracy del texto; donde la función es más empinada que max_gradient puede saltarse la superficie.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Marks the pixels that are not proven to be right; mostly there are none.&lt;/p&gt;&lt;p&gt;The certified root finder leaves a pixel unproven when a root closer than accuracy/100 may hide there, when the ray took too many evaluations, or when the function has no known bounds.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Marca los píxeles cuya corrección no está demostrada; casi siempre ninguno.&lt;/p&gt;&lt;p&gt;El buscador de raíces certificado deja un píxel sin demostrar cuando ahí puede ocultarse una raíz más próxima que accuracy/100, cuando el rayo costó demasiadas evaluaciones o cuando no se conocen cotas de la función.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Shows where POV-Ray&apos;s picture would have holes, over the exact picture.&lt;/p&gt;&lt;p&gt;Both root finders are run; pixels are lost, gained, or found at a wrong place.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Muestra dónde tendría huecos la imagen de POV-Ray, sobre la imagen exacta.&lt;/p&gt;&lt;p&gt;Se ejecutan ambos buscadores de raíces; los píxeles se pierden, sobran o se hallan en lugar erróneo.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Shows both pictures side by side: POV-Ray&apos;s at the left, the exact one at the right. Drag the divider.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Muestra ambas imágenes juntas: la de POV-Ray a la izquierda, la exacta a la derecha. Arrastre el divisor.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Shows only what POV-Ray&apos;s picture gets wrong, without the picture itself.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Muestra solo lo que la imagen de POV-Ray tiene mal, sin la imagen misma.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Colours the surface by how steep the function is there; red is too steep for POV-Ray.&lt;/p&gt;&lt;p&gt;The colour is the length of the gradient as a share of max_gradient.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Colorea la superficie según lo empinada que es ahí la función; rojo es demasiado para POV-Ray.&lt;/p&gt;&lt;p&gt;El color es la longitud del gradiente como parte de max_gradient.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Has the POV-Ray that is installed draw the text, in a folder of its own, and shows its picture left of a divider that can be dragged, the exact one right of it. It is drawn anew for every view that rests.&lt;/p&gt;</source>
        <translation>&lt;p&gt;El POV-Ray instalado dibuja el texto, en una carpeta propia, y se muestra su imagen a la izquierda de un divisor que se puede arrastrar, la exacta a la derecha. Se dibuja de nuevo para cada vista en reposo.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Has the POV-Ray that is installed draw the text and marks each pixel that differs from the exact picture by its cause: holes, accuracy, jumps, outlines, and what is not shown here.&lt;/p&gt;</source>
        <translation>&lt;p&gt;El POV-Ray instalado dibuja el texto y se marca cada píxel que difiere de la imagen exacta según su causa: huecos, accuracy, saltos, contornos y lo que aquí no se muestra.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Shows what you change beside what was.&lt;/p&gt;&lt;p&gt;The scene is kept as it is at this moment (A); from now on it is drawn left of the divider, and the present one (B) right of it: other values, or another function. Choose it again to keep the present scene instead.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Muestra lo que cambia junto a lo que había.&lt;/p&gt;&lt;p&gt;La escena se conserva como está en este momento (A); desde ahora se dibuja a la izquierda del divisor, y la actual (B) a la derecha: otros valores u otra función. Elíjalo de nuevo para conservar en su lugar la escena actual.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Shows the picture alone, with nothing laid over it.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Muestra solo la imagen, sin nada encima.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Click a pixel to see why it looks as it does: how the function runs along the line of sight, where the surface is met, and what POV-Ray stepped over.&lt;/p&gt;&lt;p&gt;The panel “Ray” charts the function over the distance along the &lt;b&gt;ray&lt;/b&gt;.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Pulse un píxel para ver por qué se ve así: cómo va la función por la línea de visión, dónde se encuentra la superficie y qué se saltó POV-Ray.&lt;/p&gt;&lt;p&gt;El panel «Rayo» muestra la función sobre la distancia a lo largo del &lt;b&gt;rayo&lt;/b&gt;.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Shows where the object is cut, and lets you drag the cut.&lt;/p&gt;&lt;p&gt;The &lt;b&gt;cross-section&lt;/b&gt; shows the values of the function on that plane.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Muestra por dónde se corta el objeto y deja arrastrar el corte.&lt;/p&gt;&lt;p&gt;La &lt;b&gt;sección&lt;/b&gt; muestra los valores de la función en ese plano.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Shows what each pixel takes in evaluations of the function, the brighter the more, in the colour of the cause: empty space in the container, a field that is steep elsewhere, rays along the surface, places where the function jumps.&lt;/p&gt;&lt;p&gt;It counts for the root finder of the picture, exact or as POV-Ray.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Muestra lo que requiere cada píxel en evaluaciones de la función, más claro cuanto más, en el color de la causa: espacio vacío en el contenedor, un campo que es empinado en otras partes, rayos a lo largo de la superficie, lugares donde la función salta.&lt;/p&gt;&lt;p&gt;Cuenta para el buscador de raíces de la imagen, exacto o como POV-Ray.&lt;/p&gt;</translation>
    </message>
</context>
</TS>
