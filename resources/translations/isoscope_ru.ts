<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ru" sourcelanguage="en">
<context>
    <name>CostOverlay</name>
    <message>
        <source>empty space: a smaller container would save it (%1, %2)</source>
        <translation>пустота: её убрал бы меньший контейнер (%1, %2)</translation>
    </message>
    <message>
        <source>finding the surface (%1, %2)</source>
        <translation>поиск поверхности (%1, %2)</translation>
    </message>
    <message>
        <source>steep field: f is flatter here than it may be elsewhere (%1, %2)</source>
        <translation>крутое поле: f здесь положе, чем может быть в других местах (%1, %2)</translation>
    </message>
    <message>
        <source>grazing rays: along the surface (%1, %2)</source>
        <translation>скользящие лучи: вдоль поверхности (%1, %2)</translation>
    </message>
    <message>
        <source>singularity: f jumps, is undefined or infinitely steep (%1, %2)</source>
        <translation>сингулярность: f скачет, не определена или бесконечно крута (%1, %2)</translation>
    </message>
    <message>
        <source>No function is evaluated in this view</source>
        <translation>В этом виде функции не вычисляются</translation>
    </message>
    <message>
        <source>Evaluations of f by the rays of the camera: %1 for a pixel, at most %2</source>
        <translation>Вычислений f лучами камеры: %1 на пиксель, не более %2</translation>
    </message>
</context>
<context>
    <name>EditorKeys</name>
    <message>
        <source>To the character before</source>
        <translation>К предыдущему символу</translation>
    </message>
    <message>
        <source>To the next character</source>
        <translation>К следующему символу</translation>
    </message>
    <message>
        <source>To the line above</source>
        <translation>На строку выше</translation>
    </message>
    <message>
        <source>To the line below</source>
        <translation>На строку ниже</translation>
    </message>
    <message>
        <source>To the word before</source>
        <translation>К предыдущему слову</translation>
    </message>
    <message>
        <source>To the next word</source>
        <translation>К следующему слову</translation>
    </message>
    <message>
        <source>To the beginning of the line</source>
        <translation>В начало строки</translation>
    </message>
    <message>
        <source>To the end of the line</source>
        <translation>В конец строки</translation>
    </message>
    <message>
        <source>A page up</source>
        <translation>На страницу вверх</translation>
    </message>
    <message>
        <source>A page down</source>
        <translation>На страницу вниз</translation>
    </message>
    <message>
        <source>To the beginning of the text</source>
        <translation>В начало текста</translation>
    </message>
    <message>
        <source>To the end of the text</source>
        <translation>В конец текста</translation>
    </message>
    <message>
        <source>Close the list of words or the help on a function</source>
        <translation>Закрыть список слов или справку о функции</translation>
    </message>
    <message>
        <source>New line</source>
        <translation>Новая строка</translation>
    </message>
    <message>
        <source>Indent, or take a word from the list</source>
        <translation>Отступ или слово из списка</translation>
    </message>
    <message>
        <source>Take indentation away</source>
        <translation>Убрать отступ</translation>
    </message>
    <message>
        <source>Delete the character before</source>
        <translation>Удалить предыдущий символ</translation>
    </message>
    <message>
        <source>Delete the next character</source>
        <translation>Удалить следующий символ</translation>
    </message>
    <message>
        <source>Delete to the beginning of the word</source>
        <translation>Удалить до начала слова</translation>
    </message>
    <message>
        <source>Delete to the end of the word</source>
        <translation>Удалить до конца слова</translation>
    </message>
    <message>
        <source>Number at the caret: one step up</source>
        <translation>Число у курсора: на шаг больше</translation>
    </message>
    <message>
        <source>Number at the caret: one step down</source>
        <translation>Число у курсора: на шаг меньше</translation>
    </message>
    <message>
        <source>Number at the caret: a tenth of a step up</source>
        <translation>Число у курсора: на десятую шага больше</translation>
    </message>
    <message>
        <source>Number at the caret: a tenth of a step down</source>
        <translation>Число у курсора: на десятую шага меньше</translation>
    </message>
    <message>
        <source>Number at the caret: ten steps up</source>
        <translation>Число у курсора: на десять шагов больше</translation>
    </message>
    <message>
        <source>Number at the caret: ten steps down</source>
        <translation>Число у курсора: на десять шагов меньше</translation>
    </message>
</context>
<context>
    <name>Gallery</name>
    <message>
        <source>POV-Ray&apos;s snippet: %1</source>
        <translation>Фрагмент POV-Ray: %1</translation>
    </message>
</context>
<context>
    <name>HeatOverlay</name>
    <message>
        <source>No isosurface is seen in this view</source>
        <translation>В этом виде изоповерхностей не видно</translation>
    </message>
    <message>
        <source>Gradient here: at most %1 of max_gradient</source>
        <translation>Градиент здесь: не более %1 от max_gradient</translation>
    </message>
    <message>
        <source>Gradient here: up to %1 times max_gradient, over it in %2 of %3 pixels</source>
        <translation>Градиент здесь: до %1 max_gradient, больше него в %2 из %3 пикселей</translation>
    </message>
    <message>
        <source>|∇f| ÷ max_gradient</source>
        <translation>|∇f| ÷ max_gradient</translation>
    </message>
    <message>
        <source>over %1</source>
        <translation>больше %1</translation>
    </message>
</context>
<context>
    <name>HelpPanel</name>
    <message>
        <source>It has no parameters but the place.</source>
        <translation>У неё нет параметров, кроме места.</translation>
    </message>
    <message>
        <source>| formula | parameter | usual value | range |</source>
        <translation>| формула | параметр | обычное значение | диапазон |</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>от %1 до %2</translation>
    </message>
    <message>
        <source>Formula</source>
        <translation>Формула</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Параметры</translation>
    </message>
    <message>
        <source>In a scene</source>
        <translation>В сцене</translation>
    </message>
    <message>
        <source>All built-in functions</source>
        <translation>Все встроенные функции</translation>
    </message>
    <message>
        <source>Numbered functions</source>
        <translation>Нумерованные функции</translation>
    </message>
    <message>
        <source>Patterns as functions</source>
        <translation>Узоры как функции</translation>
    </message>
    <message>
        <source>Built-in functions</source>
        <translation>Встроенные функции</translation>
    </message>
</context>
<context>
    <name>HoleOverlay</name>
    <message>
        <source>POV-Ray&apos;s method loses none of %1 pixels</source>
        <translation>Метод POV-Ray не теряет ни одного из %1 пикселей</translation>
    </message>
    <message>
        <source>POV-Ray&apos;s method: %1 lost, %2 gained, %3 at a wrong place</source>
        <translation>Метод POV-Ray: потеряно %1, лишних %2, не на месте %3</translation>
    </message>
    <message>
        <source>lost: a hole in POV-Ray&apos;s picture (%1)</source>
        <translation>потеряно: дыра в изображении POV-Ray (%1)</translation>
    </message>
    <message>
        <source>gained: POV-Ray hits where nothing is (%1)</source>
        <translation>лишнее: POV-Ray попадает туда, где ничего нет (%1)</translation>
    </message>
    <message>
        <source>wrong place: another sheet, or off by more than accuracy explains (%1)</source>
        <translation>не на месте: другой лист или дальше, чем объясняет accuracy (%1)</translation>
    </message>
</context>
<context>
    <name>PictureQueueWindow</name>
    <message>
        <source>%1 s</source>
        <translation>%1 с</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 мин</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 ч</translation>
    </message>
    <message>
        <source>Waits</source>
        <translation>Ждёт</translation>
    </message>
    <message>
        <source>Is rendered…</source>
        <translation>Рисуется…</translation>
    </message>
    <message>
        <source>About %1 left</source>
        <translation>Осталось около %1</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>Записано</translation>
    </message>
    <message>
        <source>Stopped; nothing was written</source>
        <translation>Остановлено; ничего не записано</translation>
    </message>
</context>
<context>
    <name>PovrayOverlay</name>
    <message>
        <source>hole: max_gradient is too low (%1)</source>
        <translation>дыра: max_gradient слишком мал (%1)</translation>
    </message>
    <message>
        <source>POV-Ray hits where nothing is (%1)</source>
        <translation>POV-Ray попадает туда, где ничего нет (%1)</translation>
    </message>
    <message>
        <source>another sheet: max_gradient is too low (%1)</source>
        <translation>другой лист: max_gradient слишком мал (%1)</translation>
    </message>
    <message>
        <source>other shades, by accuracy (%1)</source>
        <translation>другие оттенки из-за accuracy (%1)</translation>
    </message>
    <message>
        <source>the function jumps there (%1)</source>
        <translation>функция здесь скачет (%1)</translation>
    </message>
    <message>
        <source>outline: a part of a pixel (%1)</source>
        <translation>контур: часть пикселя (%1)</translation>
    </message>
    <message>
        <source>not shown here, see Problems (%1)</source>
        <translation>здесь не показано, см. «Проблемы» (%1)</translation>
    </message>
    <message>
        <source>for another reason (%1)</source>
        <translation>по другой причине (%1)</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Type a function of x, y, z in POV-Ray&apos;s language and see its surface at once.</source>
        <translation>Введите функцию от x, y, z на языке POV-Ray и сразу увидите её поверхность.</translation>
    </message>
    <message>
        <source>Write a picture of the window to OUT.png as soon as everything is drawn, then end.</source>
        <translation>Записать изображение окна в OUT.png, как только всё нарисовано, и завершить работу.</translation>
    </message>
    <message>
        <source>Size of the window.</source>
        <translation>Размер окна.</translation>
    </message>
    <message>
        <source>system, light, dark or high-contrast.</source>
        <translation>system, light, dark или high-contrast.</translation>
    </message>
    <message>
        <source>A .pov, .inc or .vl file to open.</source>
        <translation>Файл .pov, .inc или .vl, который открыть.</translation>
    </message>
    <message>
        <source>A new scene</source>
        <translation>Новая сцена</translation>
    </message>
    <message>
        <source> px</source>
        <translation> пикс.</translation>
    </message>
</context>
<context>
    <name>RayExplanation</name>
    <message>
        <source>%1 samples, bound %2 per unit of distance.</source>
        <translation>Отсчётов: %1, граница %2 на единицу расстояния.</translation>
    </message>
    <message>
        <source>It dismissed the interval from %1 to %2, for it takes f to be no steeper than %3; there it is up to %4.</source>
        <translation>Отброшен интервал от %1 до %2: f считается не круче %3, а там она достигает %4.</translation>
    </message>
    <message>
        <source>Nothing is hit. </source>
        <translation>Ничего не задето. </translation>
    </message>
    <message>
        <source>POV-Ray&apos;s method hits at %1, where nothing is. </source>
        <translation>Метод POV-Ray попадает в %1, где ничего нет. </translation>
    </message>
    <message>
        <source>POV-Ray&apos;s method misses the surface at %1. </source>
        <translation>Метод POV-Ray пропускает поверхность в %1. </translation>
    </message>
    <message>
        <source>POV-Ray&apos;s method hits at %1, where nothing is; the surface is at %2. </source>
        <translation>Метод POV-Ray попадает в %1, где ничего нет; поверхность в %2. </translation>
    </message>
    <message>
        <source>POV-Ray&apos;s method misses the surface at %1 and hits further back, at %2. </source>
        <translation>Метод POV-Ray пропускает поверхность в %1 и попадает дальше, в %2. </translation>
    </message>
    <message>
        <source>POV-Ray&apos;s method finds the surface at %1, off by %2. </source>
        <translation>Метод POV-Ray находит поверхность в %1, с ошибкой %2. </translation>
    </message>
    <message>
        <source>Yet its picture has a hole here: it dismisses rays too close to one that missed before.</source>
        <translation>Но в его изображении здесь дыра: он отбрасывает лучи слишком близко к тому, что промахнулся раньше.</translation>
    </message>
</context>
<context>
    <name>ShortcutWindow</name>
    <message>
        <source>%1; with Shift: selects</source>
        <translation>%1; с Shift: выделяет</translation>
    </message>
    <message>
        <source>In the picture</source>
        <translation>На изображении</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Повернуть</translation>
    </message>
    <message>
        <source>Left drag, arrow keys</source>
        <translation>Тянуть левой кнопкой, стрелки</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Сдвинуть</translation>
    </message>
    <message>
        <source>Right or middle drag, Shift+drag, Shift+arrow keys</source>
        <translation>Тянуть правой или средней кнопкой, Shift+тянуть, Shift+стрелки</translation>
    </message>
    <message>
        <source>Come nearer, go away</source>
        <translation>Приблизиться, отдалиться</translation>
    </message>
    <message>
        <source>Wheel, + and -</source>
        <translation>Колесо, + и -</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>Показать всё</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>Back to the camera of the text</source>
        <translation>Вернуться к камере текста</translation>
    </message>
    <message>
        <source>Double click, Home</source>
        <translation>Двойной щелчок, Home</translation>
    </message>
    <message>
        <source>Stop the picture</source>
        <translation>Остановить изображение</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Move the divider of a split view</source>
        <translation>Сдвинуть границу разделённого вида</translation>
    </message>
    <message>
        <source>Drag it, Alt+Left, Alt+Right</source>
        <translation>Тянуть её, Alt+Влево, Alt+Вправо</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Меню</translation>
    </message>
    <message>
        <source>Right click, Menu</source>
        <translation>Правый щелчок, Menu</translation>
    </message>
    <message>
        <source>In the text</source>
        <translation>В тексте</translation>
    </message>
    <message>
        <source>With the mouse in the text</source>
        <translation>Мышью в тексте</translation>
    </message>
    <message>
        <source>Change the number under the mouse</source>
        <translation>Изменить число под мышью</translation>
    </message>
    <message>
        <source>Ctrl+drag; Alt+drag and Alt+wheel</source>
        <translation>Ctrl+тянуть; Alt+тянуть и Alt+колесо</translation>
    </message>
    <message>
        <source>A tenth of a step, or ten</source>
        <translation>Десятая шага или десять</translation>
    </message>
    <message>
        <source>Shift, or the other of Ctrl and Alt, as well</source>
        <translation>Ещё и Shift или вторая из Ctrl и Alt</translation>
    </message>
    <message>
        <source>Take a drag back</source>
        <translation>Отменить перетаскивание</translation>
    </message>
    <message>
        <source>Esc, before the button is released</source>
        <translation>Esc, пока кнопка не отпущена</translation>
    </message>
    <message>
        <source>Size of the letters</source>
        <translation>Размер букв</translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation>Ctrl+колесо</translation>
    </message>
    <message>
        <source>In the panels</source>
        <translation>На панелях</translation>
    </message>
    <message>
        <source>Parameter: back to its first value</source>
        <translation>Параметр: вернуть первое значение</translation>
    </message>
    <message>
        <source>Double click on the name</source>
        <translation>Двойной щелчок по имени</translation>
    </message>
    <message>
        <source>Parameter: another end of its range</source>
        <translation>Параметр: другой край диапазона</translation>
    </message>
    <message>
        <source>Double click on the end</source>
        <translation>Двойной щелчок по краю</translation>
    </message>
    <message>
        <source>Cross-section: shift, zoom, see all</source>
        <translation>Сечение: сдвиг, масштаб, всё целиком</translation>
    </message>
    <message>
        <source>Drag, wheel, double click</source>
        <translation>Тянуть, колесо, двойной щелчок</translation>
    </message>
    <message>
        <source>Help: the page before, the next one</source>
        <translation>Справка: предыдущая страница, следующая</translation>
    </message>
    <message>
        <source>Alt+Left, Alt+Right</source>
        <translation>Alt+Влево, Alt+Вправо</translation>
    </message>
    <message>
        <source>Help: back to the text</source>
        <translation>Справка: назад к тексту</translation>
    </message>
</context>
<context>
    <name>StudyPanels</name>
    <message>
        <source>The threshold does not stand in the text itself; it is not changed.</source>
        <translation>Порог записан не в самом тексте; он не меняется.</translation>
    </message>
    <message>
        <source>Cross-section</source>
        <translation>Сечение</translation>
    </message>
    <message>
        <source>&lt;p&gt;The function on a plane: blue is inside the solid, orange outside, the bold line is the surface.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Функция на плоскости: синее внутри тела, оранжевое снаружи, жирная линия — поверхность.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation>Градиент</translation>
    </message>
    <message>
        <source>&lt;p&gt;How steep the function is, and what max_gradient has to be for a picture without holes: with proof.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Насколько крута функция и каким должен быть max_gradient для изображения без дыр: с доказательством.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation>Гистограмма</translation>
    </message>
    <message>
        <source>&lt;p&gt;How much of the container and of the surface is how steep: where a smaller max_gradient would begin to lose pixels.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Какая часть контейнера и поверхности насколько крута: где меньший max_gradient начал бы терять пиксели.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Уровни</translation>
    </message>
    <message>
        <source>&lt;p&gt;How often the function takes which value, and the thresholds at which pieces of the surface appear, join or get tunnels: with proof.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Как часто функция принимает каждое значение, и пороги, при которых части поверхности появляются, сливаются или получают туннели: с доказательством.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Точность</translation>
    </message>
    <message>
        <source>&lt;p&gt;What accuracy and max_gradient cost in time, and lose in pixels, over a range of values.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Сколько времени стоят accuracy и max_gradient и сколько пикселей теряют в диапазоне значений.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Sweep</source>
        <translation>Перебор</translation>
    </message>
    <message>
        <source>&lt;p&gt;What the values of a number cost in evaluations, how steep they make the function, and into how many pieces, tunnels and hollows: over a range of values.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Сколько вычислений стоят значения числа, насколько крутой делают функцию и на сколько частей, туннелей и полостей: в диапазоне значений.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Отчёт</translation>
    </message>
    <message>
        <source>&lt;p&gt;What the solid is like: pieces, tunnels, extent, volume, area, walls and symmetry, in sentences; and the health of the function: where it has no value, bound, slope or digits.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Каково тело: части, туннели, протяжённость, объём, площадь, стенки и симметрия, словами; и здоровье функции: где у неё нет значения, границы, наклона или верных цифр.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Ray</source>
        <translation>Луч</translation>
    </message>
    <message>
        <source>&lt;p&gt;The function along the line of sight through one pixel: where the surface is met, and what POV-Ray stepped over.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Функция вдоль линии взгляда через один пиксель: где встречается поверхность и что перешагнул POV-Ray.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Effects</source>
        <translation>Эффекты</translation>
    </message>
    <message>
        <source>&lt;p&gt;What the picture is made of, what each part costs, and switches for them.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Из чего состоит изображение, сколько стоит каждая часть, и выключатели для них.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Лист</translation>
    </message>
    <message>
        <source>&lt;p&gt;The scene in small for values of one number, or of two, as one picture; a click on one of them sets its values.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Сцена в миниатюре для значений одного числа или двух, одним изображением; щелчок по миниатюре задаёт её значения.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Formula</source>
        <translation>Формула</translation>
    </message>
    <message>
        <source>&lt;p&gt;Quicker or more exact ways to write the function, each with its proof; and its derivatives, with a function whose gradient is 1 on the surface, as text.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Более быстрые или точные записи функции, каждая с доказательством; и её производные с функцией, градиент которой на поверхности равен 1, в виде текста.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Evaluate</source>
        <translation>Evaluate</translation>
    </message>
    <message>
        <source>&lt;p&gt;Whether evaluate pays for an isosurface in this view, and with which numbers: measured cost and lost pixels of each.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Выгоден ли evaluate для изоповерхности в этом виде и с какими числами: измеренная стоимость и потерянные пиксели для каждых.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>Исправление</translation>
    </message>
    <message>
        <source>&lt;p&gt;Every isosurface of the scene and its include files: what its max_gradient is worth, and what it should be, with proof; one click writes what is ticked.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Каждая изоповерхность сцены и её файлов include: чего стоит её max_gradient и каким он должен быть, с доказательством; один щелчок записывает отмеченное.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>TimelineRow</name>
    <message>
        <source>%1 = %2 at frame %3</source>
        <translation>%1 = %2 на кадре %3</translation>
    </message>
    <message>
        <source>, then %1</source>
        <translation>, затем %1</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Камера</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Плавно</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Равномерно</translation>
    </message>
    <message>
        <source>Slow start</source>
        <translation>Медленное начало</translation>
    </message>
    <message>
        <source>Slow end</source>
        <translation>Медленный конец</translation>
    </message>
    <message>
        <source>Curve through the keys</source>
        <translation>Кривая через ключи</translation>
    </message>
    <message>
        <source>Hold, then jump</source>
        <translation>Держать, затем скачок</translation>
    </message>
</context>
<context>
    <name>VerdictOverlay</name>
    <message>
        <source>the surface: proven</source>
        <translation>поверхность: доказано</translation>
    </message>
    <message>
        <source>nothing there: proven</source>
        <translation>ничего нет: доказано</translation>
    </message>
    <message>
        <source>unproven: proven but for places below accuracy/100 (a gap)</source>
        <translation>не доказано: доказано, кроме мест меньше accuracy/100 (щель)</translation>
    </message>
    <message>
        <source>unproven: took too long, so the rest of the ray was sampled</source>
        <translation>не доказано: слишком долго, остаток луча взят по отсчётам</translation>
    </message>
    <message>
        <source>unproven: no bounds of the function are known</source>
        <translation>не доказано: границы функции неизвестны</translation>
    </message>
    <message>
        <source>%1 proven</source>
        <translation>доказано %1</translation>
    </message>
    <message>
        <source>1 unproven pixel</source>
        <translation>1 недоказанный пиксель</translation>
    </message>
    <message>
        <source>%1 unproven pixels</source>
        <translation>недоказанных пикселей: %1</translation>
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
        <translation>скачок</translation>
    </message>
    <message>
        <source>an infinite slope</source>
        <translation>бесконечный наклон</translation>
    </message>
    <message>
        <source>a pole</source>
        <translation>полюс</translation>
    </message>
    <message>
        <source>an overflow</source>
        <translation>переполнение</translation>
    </message>
    <message>
        <source>an unknown bound</source>
        <translation>неизвестная граница</translation>
    </message>
    <message>
        <source>being proven</source>
        <translation>доказывается</translation>
    </message>
    <message>
        <source>no holes</source>
        <translation>без дыр</translation>
    </message>
    <message>
        <source>slower than need be</source>
        <translation>медленнее, чем нужно</translation>
    </message>
    <message>
        <source>infinitely steep</source>
        <translation>бесконечно крута</translation>
    </message>
    <message>
        <source>not proven</source>
        <translation>не доказано</translation>
    </message>
    <message>
        <source>holes</source>
        <translation>дыры</translation>
    </message>
    <message>
        <source>may have holes</source>
        <translation>возможны дыры</translation>
    </message>
    <message>
        <source>Whether POV-Ray&apos;s picture has holes here is being found out.</source>
        <translation>Выясняется, есть ли здесь дыры в изображении POV-Ray.</translation>
    </message>
    <message>
        <source>POV-Ray&apos;s picture has holes: it gets %1 of this view wrong.</source>
        <translation>В изображении POV-Ray есть дыры: неверно %1 этого вида.</translation>
    </message>
    <message>
        <source>POV-Ray&apos;s picture has no holes here, from wherever you look.</source>
        <translation>В изображении POV-Ray здесь нет дыр, откуда ни смотреть.</translation>
    </message>
    <message>
        <source>POV-Ray takes %1 times as long for this view as it has to.</source>
        <translation>POV-Ray тратит на этот вид в %1 раз больше времени, чем нужно.</translation>
    </message>
    <message>
        <source>POV-Ray may take longer than it has to.</source>
        <translation>POV-Ray, возможно, тратит больше времени, чем нужно.</translation>
    </message>
    <message>
        <source>No holes in this view; other views may have some, whatever the setting.</source>
        <translation>В этом виде дыр нет; в других они возможны при любой настройке.</translation>
    </message>
    <message>
        <source>The function is infinitely steep somewhere: views may have holes.</source>
        <translation>Функция где-то бесконечно крута: в видах возможны дыры.</translation>
    </message>
    <message>
        <source>No holes in this view; whether others have some is not proven.</source>
        <translation>В этом виде дыр нет; есть ли они в других, не доказано.</translation>
    </message>
    <message>
        <source>Whether POV-Ray&apos;s picture has holes is not proven.</source>
        <translation>Не доказано, есть ли дыры в изображении POV-Ray.</translation>
    </message>
    <message>
        <source>No holes in this view; other views may have some.</source>
        <translation>В этом виде дыр нет; в других возможны.</translation>
    </message>
    <message>
        <source>POV-Ray&apos;s picture may have holes.</source>
        <translation>В изображении POV-Ray возможны дыры.</translation>
    </message>
    <message>
        <source>max_gradient is %1, but the gradient has no bound: %2 at %3.</source>
        <translation>max_gradient равен %1, но градиент не ограничен: %2 в %3.</translation>
    </message>
    <message>
        <source>max_gradient is %1, but the gradient is %2 at %3.</source>
        <translation>max_gradient равен %1, но градиент равен %2 в %3.</translation>
    </message>
    <message>
        <source>max_gradient is %1; the function may jump somewhere.</source>
        <translation>max_gradient равен %1; функция может где-то скакать.</translation>
    </message>
    <message>
        <source>max_gradient is %1; the gradient is at least %2, and nothing is known above that.</source>
        <translation>max_gradient равен %1; градиент не меньше %2, выше ничего не известно.</translation>
    </message>
    <message>
        <source>max_gradient is %1; the largest gradient lies between %2 and %3.</source>
        <translation>max_gradient равен %1; наибольший градиент между %2 и %3.</translation>
    </message>
    <message>
        <source>max_gradient is %1; it is proven that no gradient exceeds %2.</source>
        <translation>max_gradient равен %1; доказано, что градиент не превышает %2.</translation>
    </message>
</context>
<context>
    <name>isoscope::AboutDialog</name>
    <message>
        <source>About Isoscope</source>
        <translation>О программе Isoscope</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Isoscope %1&lt;/h3&gt;&lt;p&gt;An instrument for isosurfaces: type a function of x, y, z in POV-Ray&apos;s language and see its surface at once.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later; without any warranty.&lt;/p&gt;&lt;p&gt;With Qt %2, VTK %3, QScintilla, oneTBB, Highway, SLEEF and GLM. POV-Ray is a trademark of its owner; this program contains none of its code.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Isoscope %1&lt;/h3&gt;&lt;p&gt;Прибор для изоповерхностей: введите функцию от x, y, z на языке POV-Ray и сразу увидите её поверхность.&lt;/p&gt;&lt;p&gt;Свободная программа под лицензией GNU General Public License версии 3 или новее; без всяких гарантий.&lt;/p&gt;&lt;p&gt;С Qt %2, VTK %3, QScintilla, oneTBB, Highway, SLEEF и GLM. POV-Ray — торговая марка её владельца; в этой программе нет его кода.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>isoscope::AccuracyPanel</name>
    <message>
        <source>The setting whose values are tried</source>
        <translation>Настройка, значения которой пробуются</translation>
    </message>
    <message>
        <source>Setting that is studied</source>
        <translation>Изучаемая настройка</translation>
    </message>
    <message>
        <source>Measure or stop</source>
        <translation>Измерить или остановить</translation>
    </message>
    <message>
        <source>Progress of the measurement</source>
        <translation>Ход измерения</translation>
    </message>
    <message>
        <source>How much of the measurement is done</source>
        <translation>Какая часть измерения сделана</translation>
    </message>
    <message>
        <source>About the measurement</source>
        <translation>Об измерении</translation>
    </message>
    <message>
        <source>accuracy study</source>
        <translation>изучение точности</translation>
    </message>
    <message>
        <source>CPU seconds of the picture</source>
        <translation>Секунды процессора на изображение</translation>
    </message>
    <message>
        <source>Evaluations per pixel</source>
        <translation>Вычислений на пиксель</translation>
    </message>
    <message>
        <source>What the left chart shows</source>
        <translation>Что показывает левый график</translation>
    </message>
    <message>
        <source>Pixels missed</source>
        <translation>Потеряно пикселей</translation>
    </message>
    <message>
        <source>Pixels wrong in any way</source>
        <translation>Сколько-либо неверных пикселей</translation>
    </message>
    <message>
        <source>Worst error in t</source>
        <translation>Худшая ошибка t</translation>
    </message>
    <message>
        <source>Mean error in t</source>
        <translation>Средняя ошибка t</translation>
    </message>
    <message>
        <source>What the right chart shows</source>
        <translation>Что показывает правый график</translation>
    </message>
    <message>
        <source>Click to write a value into the text</source>
        <translation>Щелчок записывает значение в текст</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Стоп</translation>
    </message>
    <message>
        <source>Measure Again</source>
        <translation>Измерить снова</translation>
    </message>
    <message>
        <source>End the measurement; what is measured stays</source>
        <translation>Закончить измерение; измеренное остаётся</translation>
    </message>
    <message>
        <source>Render the view with nine values, three times each</source>
        <translation>Нарисовать вид с девятью значениями, по три раза</translation>
    </message>
    <message>
        <source>It is measured as soon as nothing moves.</source>
        <translation>Измеряется, как только ничто не движется.</translation>
    </message>
    <message>
        <source>The scene has no isosurface to measure.</source>
        <translation>В сцене нет изоповерхности для измерения.</translation>
    </message>
    <message>
        <source>POV-Ray</source>
        <translation>POV-Ray</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>точно</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>сейчас %1</translation>
    </message>
    <message>
        <source>Chart over %1</source>
        <translation>График по %1</translation>
    </message>
    <message>
        <source>Choosing the size of the picture…</source>
        <translation>Выбирается размер изображения…</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 пикселей</translation>
    </message>
    <message>
        <source>Measured before the last change of scene or view.</source>
        <translation>Измерено до последнего изменения сцены или вида.</translation>
    </message>
    <message>
        <source>%1; stopped early.</source>
        <translation>%1; остановлено раньше.</translation>
    </message>
    <message>
        <source>%1, median of 3 runs</source>
        <translation>%1, медиана 3 прогонов</translation>
    </message>
    <message>
        <source>Click for %1 %2.</source>
        <translation>Щелчок задаёт %1 %2.</translation>
    </message>
</context>
<context>
    <name>isoscope::Actions</name>
    <message>
        <source>Inc&amp;lude Folders…</source>
        <translation>Папки вкл&amp;ючений…</translation>
    </message>
    <message>
        <source>Where #include looks besides the folder of the file</source>
        <translation>Где ищет #include, кроме папки файла</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Справка</translation>
    </message>
    <message>
        <source>Open the page about the word at the caret, or about the panel with the focus</source>
        <translation>Открыть страницу о слове у курсора или о панели с фокусом</translation>
    </message>
    <message>
        <source>&amp;Lessons</source>
        <translation>&amp;Уроки</translation>
    </message>
    <message>
        <source>Open the list of short lessons about isosurfaces</source>
        <translation>Открыть список коротких уроков об изоповерхностях</translation>
    </message>
    <message>
        <source>&amp;Commands…</source>
        <translation>&amp;Команды…</translation>
    </message>
    <message>
        <source>Find a command of the menus by words and run it</source>
        <translation>Найти команду меню по словам и выполнить её</translation>
    </message>
    <message>
        <source>&amp;Keyboard Shortcuts</source>
        <translation>Сочетания к&amp;лавиш</translation>
    </message>
    <message>
        <source>All commands and their keys</source>
        <translation>Все команды и их клавиши</translation>
    </message>
    <message>
        <source>&amp;What Is This?</source>
        <translation>Что &amp;это?</translation>
    </message>
    <message>
        <source>Click anything of the window to hear what it is</source>
        <translation>Щёлкните что угодно в окне, чтобы узнать, что это</translation>
    </message>
    <message>
        <source>&amp;About Isoscope</source>
        <translation>&amp;О программе Isoscope</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>Версия и лицензия</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Создать</translation>
    </message>
    <message>
        <source>Start with an empty scene</source>
        <translation>Начать с пустой сцены</translation>
    </message>
    <message>
        <source>New &amp;Window</source>
        <translation>Новое &amp;окно</translation>
    </message>
    <message>
        <source>Open another window with a document of its own</source>
        <translation>Открыть ещё одно окно со своим документом</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Откры&amp;ть…</translation>
    </message>
    <message>
        <source>Open a scene or include file</source>
        <translation>Открыть сцену или включаемый файл</translation>
    </message>
    <message>
        <source>Start Pa&amp;ge</source>
        <translation>На&amp;чальная страница</translation>
    </message>
    <message>
        <source>Choose a scene to begin with, by its picture</source>
        <translation>Выбрать по изображению сцену для начала</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>Со&amp;хранить</translation>
    </message>
    <message>
        <source>Save the text</source>
        <translation>Сохранить текст</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Сохранить &amp;как…</translation>
    </message>
    <message>
        <source>Save the text under another name</source>
        <translation>Сохранить текст под другим именем</translation>
    </message>
    <message>
        <source>&amp;Kept Texts…</source>
        <translation>Отложенные текст&amp;ы…</translation>
    </message>
    <message>
        <source>List the texts that were kept because they were not saved</source>
        <translation>Список текстов, отложенных, потому что их не сохранили</translation>
    </message>
    <message>
        <source>Fo&amp;llow Another Editor</source>
        <translation>С&amp;ледить за другим редактором</translation>
    </message>
    <message>
        <source>Take over what another program saves to the file, while the text has no changes here</source>
        <translation>Перенимать то, что другая программа пишет в файл, пока текст здесь не изменён</translation>
    </message>
    <message>
        <source>Copy &amp;Isosurface</source>
        <translation>&amp;Копировать изоповерхность</translation>
    </message>
    <message>
        <source>Copy the isosurface at the caret, with the declarations it needs</source>
        <translation>Копировать изоповерхность у курсора с нужными ей объявлениями</translation>
    </message>
    <message>
        <source>Cop&amp;y Picture</source>
        <translation>Копировать &amp;изображение</translation>
    </message>
    <message>
        <source>Copy the picture as it is shown; Ctrl and the mouse drag it out of the window</source>
        <translation>Копировать изображение как показано; Ctrl и мышь вытаскивают его из окна</translation>
    </message>
    <message>
        <source>Copy &amp;Difference Surface</source>
        <translation>Копировать поверхность &amp;разности</translation>
    </message>
    <message>
        <source>Copy the isosurface that is 0 where the kept function and the present one agree (View, Overlay, Compare A/B)</source>
        <translation>Копировать изоповерхность, равную 0 там, где отложенная функция и нынешняя совпадают (Вид, Наложение, Сравнить A/B)</translation>
    </message>
    <message>
        <source>Isosurface as Include &amp;File…</source>
        <translation>Изоповерхность в &amp;файл include…</translation>
    </message>
    <message>
        <source>Write the isosurface at the caret, with the declarations it needs, to an .inc file</source>
        <translation>Записать изоповерхность у курсора с нужными ей объявлениями в файл .inc</translation>
    </message>
    <message>
        <source>Complete &amp;Scene for POV-Ray…</source>
        <translation>Полная &amp;сцена для POV-Ray…</translation>
    </message>
    <message>
        <source>Write a .pov file that POV-Ray renders to the picture of the viewport</source>
        <translation>Записать файл .pov, который POV-Ray превратит в это изображение</translation>
    </message>
    <message>
        <source>Objects for &amp;VirtuaLight…</source>
        <translation>Объекты для &amp;VirtuaLight…</translation>
    </message>
    <message>
        <source>Write a .vl file of the objects that VirtuaLight&apos;s notation can say</source>
        <translation>Записать файл .vl с объектами, которые выразимы на языке VirtuaLight</translation>
    </message>
    <message>
        <source>I&amp;mage…</source>
        <translation>Изо&amp;бражение…</translation>
    </message>
    <message>
        <source>Render the view to a PNG or OpenEXR file of any size</source>
        <translation>Записать вид в файл PNG или OpenEXR любого размера</translation>
    </message>
    <message>
        <source>Pictures in the Ma&amp;king…</source>
        <translation>Изображения в работ&amp;е…</translation>
    </message>
    <message>
        <source>List the images that are being rendered, and stop them</source>
        <translation>Список изображений, которые рисуются; здесь их останавливают</translation>
    </message>
    <message>
        <source>&amp;Animation for POV-Ray…</source>
        <translation>&amp;Анимация для POV-Ray…</translation>
    </message>
    <message>
        <source>Write a .pov file whose numbers follow clock as the timeline has them, and its .ini file</source>
        <translation>Записать файл .pov, числа которого следуют clock, как на шкале времени, и его файл .ini</translation>
    </message>
    <message>
        <source>F&amp;rames and Film…</source>
        <translation>Ка&amp;дры и фильм…</translation>
    </message>
    <message>
        <source>Draw the frames of the timeline into pictures, and a film where ffmpeg is installed</source>
        <translation>Нарисовать кадры шкалы времени в картинки, и фильм, если установлен ffmpeg</translation>
    </message>
    <message>
        <source>M&amp;esh…</source>
        <translation>Се&amp;тка…</translation>
    </message>
    <message>
        <source>Write the isosurfaces as triangles: STL, 3MF, OBJ, PLY, glTF, or for POV-Ray</source>
        <translation>Записать изоповерхности треугольниками: STL, 3MF, OBJ, PLY, glTF или для POV-Ray</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Выход</translation>
    </message>
    <message>
        <source>Close the window; unsaved text is kept for the next start</source>
        <translation>Закрыть окно; несохранённый текст остаётся до следующего запуска</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>О&amp;тменить</translation>
    </message>
    <message>
        <source>Take back the last change; a drag of a slider is one change</source>
        <translation>Отменить последнее изменение; одно движение ползунка — одно изменение</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Повторить</translation>
    </message>
    <message>
        <source>Do again what was taken back</source>
        <translation>Сделать снова то, что отменено</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Вырезать</translation>
    </message>
    <message>
        <source>Move the selected text to the clipboard</source>
        <translation>Перенести выделенный текст в буфер обмена</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Копировать</translation>
    </message>
    <message>
        <source>Copy the selected text to the clipboard</source>
        <translation>Копировать выделенный текст в буфер обмена</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>Вст&amp;авить</translation>
    </message>
    <message>
        <source>Insert the text of the clipboard</source>
        <translation>Вставить текст из буфера обмена</translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation>В&amp;ыделить всё</translation>
    </message>
    <message>
        <source>Select the whole text</source>
        <translation>Выделить весь текст</translation>
    </message>
    <message>
        <source>&amp;Find…</source>
        <translation>&amp;Найти…</translation>
    </message>
    <message>
        <source>Find in the text</source>
        <translation>Найти в тексте</translation>
    </message>
    <message>
        <source>Find and R&amp;eplace…</source>
        <translation>Найти и &amp;заменить…</translation>
    </message>
    <message>
        <source>Find and replace in the text</source>
        <translation>Найти и заменить в тексте</translation>
    </message>
    <message>
        <source>Find &amp;Next</source>
        <translation>Найти &amp;далее</translation>
    </message>
    <message>
        <source>Go to the next match</source>
        <translation>К следующему совпадению</translation>
    </message>
    <message>
        <source>Find Pre&amp;vious</source>
        <translation>Найти п&amp;редыдущее</translation>
    </message>
    <message>
        <source>Go to the match before</source>
        <translation>К предыдущему совпадению</translation>
    </message>
    <message>
        <source>To&amp;ggle Comment</source>
        <translation>Перекл&amp;ючить комментарий</translation>
    </message>
    <message>
        <source>Turn the selected lines into comments, or back</source>
        <translation>Превратить выделенные строки в комментарии или обратно</translation>
    </message>
    <message>
        <source>Ad&amp;just Number…</source>
        <translation>Из&amp;менить число…</translation>
    </message>
    <message>
        <source>Open a slider for the number at the caret</source>
        <translation>Открыть ползунок для числа у курсора</translation>
    </message>
    <message>
        <source>F&amp;it Container</source>
        <translation>Под&amp;огнать контейнер</translation>
    </message>
    <message>
        <source>Give the isosurface at the caret the smallest container that is proven to show the same; POV-Ray looks for roots only inside</source>
        <translation>Дать изоповерхности у курсора наименьший контейнер, доказуемо показывающий то же; POV-Ray ищет корни только внутри</translation>
    </message>
    <message>
        <source>&amp;Function…</source>
        <translation>&amp;Функция…</translation>
    </message>
    <message>
        <source>Search the built-in functions and insert one</source>
        <translation>Найти встроенную функцию и вставить её</translation>
    </message>
    <message>
        <source>&amp;Fit View</source>
        <translation>Показать &amp;всё</translation>
    </message>
    <message>
        <source>Show everything that is there, whole; F alone does it in the picture</source>
        <translation>Показать всё, что есть, целиком; на изображении достаточно F</translation>
    </message>
    <message>
        <source>From the F&amp;ront</source>
        <translation>С&amp;переди</translation>
    </message>
    <message>
        <source>Look at everything from the front</source>
        <translation>Смотреть на всё спереди</translation>
    </message>
    <message>
        <source>From A&amp;bove</source>
        <translation>&amp;Сверху</translation>
    </message>
    <message>
        <source>Look at everything from above</source>
        <translation>Смотреть на всё сверху</translation>
    </message>
    <message>
        <source>From the Rig&amp;ht</source>
        <translation>Сп&amp;рава</translation>
    </message>
    <message>
        <source>Look at everything from the right side</source>
        <translation>Смотреть на всё с правой стороны</translation>
    </message>
    <message>
        <source>&amp;As the Text Says</source>
        <translation>&amp;Как в тексте</translation>
    </message>
    <message>
        <source>Go back to the camera of the text</source>
        <translation>Вернуться к камере текста</translation>
    </message>
    <message>
        <source>&amp;Write View into Text</source>
        <translation>&amp;Записать вид в текст</translation>
    </message>
    <message>
        <source>Make the present view the camera block of the text</source>
        <translation>Сделать нынешний вид блоком camera текста</translation>
    </message>
    <message>
        <source>Re&amp;draw</source>
        <translation>Пе&amp;рерисовать</translation>
    </message>
    <message>
        <source>Render the picture again</source>
        <translation>Нарисовать изображение заново</translation>
    </message>
    <message>
        <source>Update W&amp;hile Typing</source>
        <translation>О&amp;бновлять при вводе</translation>
    </message>
    <message>
        <source>Show what is typed after a moment; else when it is saved, or on Redraw</source>
        <translation>Показывать введённое через миг; иначе при сохранении или по «Перерисовать»</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>Сто&amp;п</translation>
    </message>
    <message>
        <source>Stop the picture in the making</source>
        <translation>Остановить рисуемое изображение</translation>
    </message>
    <message>
        <source>S&amp;mooth Edges</source>
        <translation>Гладки&amp;е края</translation>
    </message>
    <message>
        <source>Render the resting picture with anti-aliasing; takes longer</source>
        <translation>Рисовать неподвижное изображение со сглаживанием; это дольше</translation>
    </message>
    <message>
        <source>E&amp;xact</source>
        <translation>&amp;Точно</translation>
    </message>
    <message>
        <source>Show the surface as it is, without holes; the certified root finder proves it</source>
        <translation>Показать поверхность как есть, без дыр; доказывает сертифицированный поиск корней</translation>
    </message>
    <message>
        <source>As PO&amp;V-Ray</source>
        <translation>Как &amp;POV-Ray</translation>
    </message>
    <message>
        <source>Show what POV-Ray will draw, holes included, with the text&apos;s max_gradient and accuracy</source>
        <translation>Показать, что нарисует POV-Ray, вместе с дырами, с max_gradient и accuracy текста</translation>
    </message>
    <message>
        <source>Containe&amp;r Outlines</source>
        <translation>Контур&amp;ы контейнеров</translation>
    </message>
    <message>
        <source>Draw the containers of the isosurfaces over the picture</source>
        <translation>Рисовать контейнеры изоповерхностей поверх изображения</translation>
    </message>
    <message>
        <source>Container</source>
        <translation>Контейнер</translation>
    </message>
    <message>
        <source>Ax&amp;es</source>
        <translation>&amp;Оси</translation>
    </message>
    <message>
        <source>Draw the axes of the scene, and how the view is turned</source>
        <translation>Рисовать оси сцены и то, как повёрнут вид</translation>
    </message>
    <message>
        <source>&amp;Cut Faces</source>
        <translation>Гр&amp;ани срезов</translation>
    </message>
    <message>
        <source>Hatch where a container cuts its isosurface; that face is no surface of the function</source>
        <translation>Штриховать место, где контейнер срезает изоповерхность; эта грань — не поверхность функции</translation>
    </message>
    <message>
        <source>Show &amp;Unproven Pixels</source>
        <translation>&amp;Недоказанные пиксели</translation>
    </message>
    <message>
        <source>Mark the pixels of the exact picture that are not proven to be right</source>
        <translation>Отметить пиксели точного изображения, верность которых не доказана</translation>
    </message>
    <message>
        <source>Unproven</source>
        <translation>Недоказано</translation>
    </message>
    <message>
        <source>&amp;System</source>
        <translation>&amp;Системная</translation>
    </message>
    <message>
        <source>Light or dark as the desktop is</source>
        <translation>Светлая или тёмная, как рабочий стол</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>Св&amp;етлая</translation>
    </message>
    <message>
        <source>Light colours</source>
        <translation>Светлые цвета</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Тёмная</translation>
    </message>
    <message>
        <source>Dark colours</source>
        <translation>Тёмные цвета</translation>
    </message>
    <message>
        <source>High &amp;Contrast</source>
        <translation>&amp;Контрастная</translation>
    </message>
    <message>
        <source>White on black, with outlines; text of at least 7:1</source>
        <translation>Белое на чёрном, с контурами; тексты не менее 7:1</translation>
    </message>
    <message>
        <source>Wrap Lon&amp;g Lines</source>
        <translation>Перенос &amp;длинных строк</translation>
    </message>
    <message>
        <source>Continue lines of the text that are too long for its panel on the next row</source>
        <translation>Продолжать на следующем ряду строки текста, слишком длинные для панели</translation>
    </message>
    <message>
        <source>&amp;Browse Gallery</source>
        <translation>Галере&amp;я</translation>
    </message>
    <message>
        <source>Choose among functions, examples and your own scenes, with pictures</source>
        <translation>Выбрать из функций, примеров и своих сцен, с изображениями</translation>
    </message>
    <message>
        <source>Ne&amp;xt Panel</source>
        <translation>С&amp;ледующая панель</translation>
    </message>
    <message>
        <source>Go to the next of panels, picture and tool bars</source>
        <translation>К следующей из панелей, изображения и панелей инструментов</translation>
    </message>
    <message>
        <source>Pre&amp;vious Panel</source>
        <translation>&amp;Предыдущая панель</translation>
    </message>
    <message>
        <source>Go to the one before of panels, picture and tool bars</source>
        <translation>К предыдущей из панелей, изображения и панелей инструментов</translation>
    </message>
    <message>
        <source>Reset La&amp;yout</source>
        <translation>Верн&amp;уть расположение</translation>
    </message>
    <message>
        <source>Put all panels back to their places</source>
        <translation>Вернуть все панели на места</translation>
    </message>
    <message>
        <source>&amp;Larger</source>
        <translation>&amp;Крупнее</translation>
    </message>
    <message>
        <source>Larger letters in the text</source>
        <translation>Буквы текста крупнее</translation>
    </message>
    <message>
        <source>&amp;Smaller</source>
        <translation>&amp;Мельче</translation>
    </message>
    <message>
        <source>Smaller letters in the text</source>
        <translation>Буквы текста мельче</translation>
    </message>
    <message>
        <source>&amp;Normal</source>
        <translation>&amp;Обычный</translation>
    </message>
    <message>
        <source>Letters of the usual size</source>
        <translation>Буквы обычного размера</translation>
    </message>
    <message>
        <source>Everything at %1 %</source>
        <translation>Всё на %1 %</translation>
    </message>
    <message>
        <source>Letters, icons and marks of the whole window at %1 % of the desktop&apos;s size</source>
        <translation>Буквы, значки и метки всего окна на %1 % размера рабочего стола</translation>
    </message>
    <message>
        <source>Texts of the window in this language, from the next start on</source>
        <translation>Тексты окна на этом языке, со следующего запуска</translation>
    </message>
    <message>
        <source>&amp;The System&apos;s Language</source>
        <translation>Язык &amp;системы</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Нет</translation>
    </message>
    <message>
        <source>Show the picture alone</source>
        <translation>Показать только изображение</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Наложение</translation>
    </message>
    <message>
        <source>&amp;Holes</source>
        <translation>&amp;Дыры</translation>
    </message>
    <message>
        <source>Mark the holes of POV-Ray&apos;s picture: pixels lost, gained or found at a wrong place</source>
        <translation>Отметить дыры в изображении POV-Ray: пиксели потерянные, лишние или не на месте</translation>
    </message>
    <message>
        <source>S&amp;plit View</source>
        <translation>&amp;Разделённый вид</translation>
    </message>
    <message>
        <source>POV-Ray&apos;s picture left of a divider, the exact one right of it</source>
        <translation>Изображение POV-Ray слева от границы, точное справа</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Раздел</translation>
    </message>
    <message>
        <source>&amp;Difference Only</source>
        <translation>&amp;Только разность</translation>
    </message>
    <message>
        <source>What POV-Ray&apos;s picture gets wrong, without the picture</source>
        <translation>Что неверно в изображении POV-Ray, без самого изображения</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Разность</translation>
    </message>
    <message>
        <source>&amp;Gradient</source>
        <translation>&amp;Градиент</translation>
    </message>
    <message>
        <source>How steep the function is on the surface, as a share of max_gradient</source>
        <translation>Насколько крута функция на поверхности, в долях max_gradient</translation>
    </message>
    <message>
        <source>&amp;Beside POV-Ray Itself</source>
        <translation>Рядом с самим &amp;POV-Ray</translation>
    </message>
    <message>
        <source>Have the installed POV-Ray draw the text: its picture left of a divider, the exact one right</source>
        <translation>Установленный POV-Ray рисует текст: его изображение слева от границы, точное справа</translation>
    </message>
    <message>
        <source>POV-Ray</source>
        <translation>POV-Ray</translation>
    </message>
    <message>
        <source>Difference &amp;from POV-Ray Itself</source>
        <translation>&amp;Отличие от самого POV-Ray</translation>
    </message>
    <message>
        <source>Have the installed POV-Ray draw the text, and mark what differs, by cause</source>
        <translation>Установленный POV-Ray рисует текст; отличия отмечаются по причинам</translation>
    </message>
    <message>
        <source>Differs</source>
        <translation>Отличие</translation>
    </message>
    <message>
        <source>&amp;Compare A/B</source>
        <translation>&amp;Сравнить A/B</translation>
    </message>
    <message>
        <source>Keep the scene as it is now, and show it left of a divider while you change it</source>
        <translation>Отложить сцену как есть и показывать её слева от границы, пока вы меняете текст</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Сравнение</translation>
    </message>
    <message>
        <source>&amp;Inspect Ray</source>
        <translation>Исследовать &amp;луч</translation>
    </message>
    <message>
        <source>Click a pixel to see the function along its ray in the panel “Ray”</source>
        <translation>Щёлкните пиксель, чтобы увидеть функцию вдоль его луча на панели «Луч»</translation>
    </message>
    <message>
        <source>Ray</source>
        <translation>Луч</translation>
    </message>
    <message>
        <source>Section &amp;Plane</source>
        <translation>&amp;Секущая плоскость</translation>
    </message>
    <message>
        <source>Show the plane of the cross-section in the picture; its square moves it, the ball turns it</source>
        <translation>Показать плоскость сечения на изображении; квадрат двигает её, шар поворачивает</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Плоскость</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Файл</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Открыть &amp;недавние</translation>
    </message>
    <message>
        <source>Open E&amp;xample</source>
        <translation>Открыть &amp;пример</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Экспорт</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Правка</translation>
    </message>
    <message>
        <source>&amp;Insert</source>
        <translation>&amp;Вставка</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>В&amp;ид</translation>
    </message>
    <message>
        <source>Loo&amp;k</source>
        <translation>Вз&amp;гляд</translation>
    </message>
    <message>
        <source>&amp;Overlay</source>
        <translation>Нало&amp;жение</translation>
    </message>
    <message>
        <source>Pa&amp;nels</source>
        <translation>Панел&amp;и</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>Те&amp;ма</translation>
    </message>
    <message>
        <source>Text Si&amp;ze</source>
        <translation>Размер &amp;шрифта</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Язык</translation>
    </message>
    <message>
        <source>Show:</source>
        <translation>Показать:</translation>
    </message>
    <message>
        <source>C&amp;ost</source>
        <translation>&amp;Затраты</translation>
    </message>
    <message>
        <source>What each pixel takes in evaluations of the function, in the colour of its cause</source>
        <translation>Сколько вычислений функции требует каждый пиксель, цветом причины</translation>
    </message>
    <message>
        <source>&amp;Comment of What Is Proven</source>
        <translation>Ко&amp;мментарий о доказанном</translation>
    </message>
    <message>
        <source>Put a comment in front of isosurfaces that states the proven bound, method, view and version; it is checked when the text is opened again</source>
        <translation>Ставить перед изоповерхностями комментарий с доказанной границей, методом, видом и версией; он проверяется, когда текст открывают снова</translation>
    </message>
</context>
<context>
    <name>isoscope::AnimationExportDialog</name>
    <message>
        <source>Frames and film</source>
        <translation>Кадры и фильм</translation>
    </message>
    <message>
        <source>ffmpeg cannot be started.</source>
        <translation>Не удаётся запустить ffmpeg.</translation>
    </message>
    <message>
        <source>ffmpeg made no film: %1</source>
        <translation>ffmpeg не сделал фильма: %1</translation>
    </message>
    <message>
        <source> px</source>
        <translation> пикс.</translation>
    </message>
    <message>
        <source>Width of the frames</source>
        <translation>Ширина кадров</translation>
    </message>
    <message>
        <source>Height of the frames</source>
        <translation>Высота кадров</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Размер</translation>
    </message>
    <message>
        <source>Smooth edges (anti-aliasing)</source>
        <translation>Гладкие края (сглаживание)</translation>
    </message>
    <message>
        <source>Several rays for pixels on edges; takes longer</source>
        <translation>Несколько лучей на пиксели краёв; это дольше</translation>
    </message>
    <message>
        <source>How the names of the pictures begin</source>
        <translation>С чего начинаются имена картинок</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Папка…</translation>
    </message>
    <message>
        <source>Choose the folder of the pictures</source>
        <translation>Выбрать папку картинок</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Файлы</translation>
    </message>
    <message>
        <source>The number of the frame and .png follow</source>
        <translation>Далее номер кадра и .png</translation>
    </message>
    <message>
        <source>Make a film of them, %1 frames per second</source>
        <translation>Сделать из них фильм, %1 кадров в секунду</translation>
    </message>
    <message>
        <source>An .mp4 file beside the pictures, made by ffmpeg</source>
        <translation>Файл .mp4 рядом с картинками, делает ffmpeg</translation>
    </message>
    <message>
        <source>ffmpeg is not installed</source>
        <translation>ffmpeg не установлен</translation>
    </message>
    <message>
        <source> (ffmpeg is not installed)</source>
        <translation> (ffmpeg не установлен)</translation>
    </message>
    <message>
        <source>%v of %m frames</source>
        <translation>%v из %m кадров</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Ход работы</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Результат</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Рисовать</translation>
    </message>
    <message>
        <source>Draw all frames and write them</source>
        <translation>Нарисовать все кадры и записать их</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Стоп</translation>
    </message>
    <message>
        <source>Stop; frames that are written stay</source>
        <translation>Остановить; записанные кадры остаются</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Закрыть</translation>
    </message>
    <message>
        <source>Close; drawing is stopped</source>
        <translation>Закрыть; рисование останавливается</translation>
    </message>
    <message>
        <source>Folder of the pictures</source>
        <translation>Папка картинок</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Заменить</translation>
    </message>
    <message>
        <source>There are frames with such names already. Replace them?</source>
        <translation>Кадры с такими именами уже есть. Заменить их?</translation>
    </message>
    <message>
        <source>Please choose how the names begin.</source>
        <translation>Укажите, с чего начинаются имена.</translation>
    </message>
    <message>
        <source>That is more than %1 million pixels.</source>
        <translation>Это больше %1 миллионов пикселей.</translation>
    </message>
    <message>
        <source>%1 is no PNG picture: it is not replaced.</source>
        <translation>%1 — не картинка PNG: она не заменяется.</translation>
    </message>
    <message>
        <source>%1 cannot be made.</source>
        <translation>Не удаётся создать %1.</translation>
    </message>
    <message>
        <source>Drawing…</source>
        <translation>Рисуется…</translation>
    </message>
    <message>
        <source>Making the film…</source>
        <translation>Делается фильм…</translation>
    </message>
    <message>
        <source>film: %v of %m frames</source>
        <translation>фильм: %v из %m кадров</translation>
    </message>
    <message>
        <source>Stopped; the frames that are written stay.</source>
        <translation>Остановлено; записанные кадры остаются.</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Записано: %1</translation>
    </message>
</context>
<context>
    <name>isoscope::ChartSaver</name>
    <message>
        <source>Save</source>
        <translation>Сохранить</translation>
    </message>
    <message>
        <source>Write the chart, or its numbers, to a file</source>
        <translation>Записать график или его числа в файл</translation>
    </message>
    <message>
        <source>Save the chart or its numbers</source>
        <translation>Сохранить график или его числа</translation>
    </message>
    <message>
        <source>Chart as &amp;SVG…</source>
        <translation>График в &amp;SVG…</translation>
    </message>
    <message>
        <source>SVG drawings (*.svg)</source>
        <translation>Рисунки SVG (*.svg)</translation>
    </message>
    <message>
        <source>Chart as &amp;PNG…</source>
        <translation>График в &amp;PNG…</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>Картинки PNG (*.png)</translation>
    </message>
    <message>
        <source>&amp;Numbers (CSV)…</source>
        <translation>&amp;Числа (CSV)…</translation>
    </message>
    <message>
        <source>CSV tables (*.csv)</source>
        <translation>Таблицы CSV (*.csv)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Сохранено: %1.</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>Не удаётся записать %1.</translation>
    </message>
</context>
<context>
    <name>isoscope::CommandKeys</name>
    <message>
        <source>A command has one combination of keys, not several in a row.</source>
        <translation>У команды одно сочетание клавиш, а не несколько подряд.</translation>
    </message>
    <message>
        <source>These keys belong to the text: %1.</source>
        <translation>Эти клавиши принадлежат тексту: %1.</translation>
    </message>
    <message>
        <source>A letter alone is text; add Ctrl or Alt.</source>
        <translation>Одна буква — это текст; добавьте Ctrl или Alt.</translation>
    </message>
</context>
<context>
    <name>isoscope::CommandPalette</name>
    <message>
        <source>Commands</source>
        <translation>Команды</translation>
    </message>
    <message>
        <source>&lt;p&gt;Every command of the menus. Type words of its name, or of what it tells of itself, and press Enter.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Все команды меню. Введите слова её названия или описания и нажмите Enter.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Type a command, then Enter</source>
        <translation>Введите команду, затем Enter</translation>
    </message>
    <message>
        <source>Words of a command</source>
        <translation>Слова команды</translation>
    </message>
    <message>
        <source>Lists the commands that these words name</source>
        <translation>Перечисляет команды, которые называют эти слова</translation>
    </message>
    <message>
        <source>Commands with their keys</source>
        <translation>Команды с их клавишами</translation>
    </message>
    <message>
        <source>The commands of the menus</source>
        <translation>Команды меню</translation>
    </message>
</context>
<context>
    <name>isoscope::ContainerFitter</name>
    <message>
        <source>Looking for the smallest container that is proven to show the same…</source>
        <translation>Ищется наименьший контейнер, доказуемо показывающий то же…</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>Сто&amp;п</translation>
    </message>
    <message>
        <source>Leaves the container as it is</source>
        <translation>Оставляет контейнер как есть</translation>
    </message>
    <message>
        <source>The text is still being read.</source>
        <translation>Текст ещё читается.</translation>
    </message>
    <message>
        <source>There is no isosurface in the text.</source>
        <translation>В тексте нет изоповерхности.</translation>
    </message>
    <message>
        <source>Looking for the smallest container…</source>
        <translation>Ищется наименьший контейнер…</translation>
    </message>
    <message>
        <source>Stopped; the container is left alone.</source>
        <translation>Остановлено; контейнер не тронут.</translation>
    </message>
    <message>
        <source>The text has changed; its container is left alone.</source>
        <translation>Текст изменился; его контейнер не тронут.</translation>
    </message>
    <message>
        <source>Nothing of this isosurface is in its container.</source>
        <translation>В контейнере этой изоповерхности ничего нет.</translation>
    </message>
    <message>
        <source>No container is proven to show the same with less room.</source>
        <translation>Меньшего контейнера, доказуемо показывающего то же, нет.</translation>
    </message>
    <message>
        <source>The isosurface does not stand in the text itself, or stands for several; its container is left alone.</source>
        <translation>Изоповерхность записана не в самом тексте или стоит за несколько; её контейнер не тронут.</translation>
    </message>
    <message>
        <source>The container has %1 % of its room now; POV-Ray takes about %2 s instead of %3 s at 640 x 480.</source>
        <translation>Контейнер занимает теперь %1 % прежнего; POV-Ray тратит около %2 с вместо %3 с при 640 x 480.</translation>
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
        <translation>от %1 до %2</translation>
    </message>
    <message>
        <source>no time</source>
        <translation>нет времени</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 с</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 мин</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 ч</translation>
    </message>
    <message>
        <source>What the setting costs in time and loses in pixels over its range; a click sets it.</source>
        <translation>Сколько времени стоит настройка и сколько пикселей теряет в своём диапазоне; щелчок задаёт её.</translation>
    </message>
    <message>
        <source>What each value of the slider above costs and loses. Orange is POV-Ray&apos;s time for a picture, blue the time of this program; both rise upwards by factors. Red below them are lost pixels: holes. The triangle marks the knee: behind it more time changes no pixel. A click sets the value, arrow keys go from one measured value to the next, Return goes to the knee.</source>
        <translation>Что стоит и что теряет каждое значение ползунка сверху. Оранжевое — время POV-Ray на изображение, синее — этой программы; оба растут вверх в разы. Красное под ними — потерянные пиксели: дыры. Треугольник отмечает излом: за ним лишнее время не меняет ни пикселя. Щелчок задаёт значение, стрелки ведут от одного измеренного значения к другому, Return — к излому.</translation>
    </message>
    <message>
        <source>What %1 costs</source>
        <translation>Что стоит %1</translation>
    </message>
    <message>
        <source>POV-Ray %1 ± %2 % at %3</source>
        <translation>POV-Ray %1 ± %2 % при %3</translation>
    </message>
    <message>
        <source>%1; none lost</source>
        <translation>%1; ничего не потеряно</translation>
    </message>
    <message>
        <source>%1; %2 lost</source>
        <translation>%1; потеряно %2</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source> (measured before the last change)</source>
        <translation> (измерено до последнего изменения)</translation>
    </message>
    <message>
        <source> (still measuring)</source>
        <translation> (ещё измеряется)</translation>
    </message>
    <message>
        <source>At %1: POV-Ray about %2, to %3 %; Isoscope about %4 of processor time</source>
        <translation>При %1: POV-Ray около %2, до %3 %; Isoscope около %4 процессора</translation>
    </message>
    <message>
        <source>Pixels lost: POV-Ray %1, Isoscope %2, of %3 that were traced</source>
        <translation>Потеряно пикселей: POV-Ray %1, Isoscope %2, из %3 взятых</translation>
    </message>
    <message>
        <source>Knee at %1: finer values cost more and change no pixel of this view</source>
        <translation>Излом при %1: более тонкие значения стоят больше и не меняют ни пикселя этого вида</translation>
    </message>
    <message>
        <source>Knee at %1: larger values cost more and change no pixel of this view</source>
        <translation>Излом при %1: большие значения стоят больше и не меняют ни пикселя этого вида</translation>
    </message>
    <message>
        <source>not measured: not in the picture shown</source>
        <translation>не измерено: нет на изображении</translation>
    </message>
    <message>
        <source>nothing to measure here</source>
        <translation>здесь нечего измерять</translation>
    </message>
    <message>
        <source>measuring what it costs…</source>
        <translation>измеряется стоимость…</translation>
    </message>
    <message>
        <source>What each value costs; it is measured as soon as all rests</source>
        <translation>Что стоит каждое значение; измеряется, как только всё в покое</translation>
    </message>
    <message>
        <source>What each value costs; it is measured once the picture shows it</source>
        <translation>Что стоит каждое значение; измеряется, как только это показано</translation>
    </message>
</context>
<context>
    <name>isoscope::DifferenceWindow</name>
    <message>
        <source>%1: the disk and the editor</source>
        <translation>%1: диск и редактор</translation>
    </message>
    <message>
        <source>Differing lines</source>
        <translation>Различающиеся строки</translation>
    </message>
    <message>
        <source>Take Theirs</source>
        <translation>Взять чужое</translation>
    </message>
    <message>
        <source>Show the text of the disk; Undo brings yours back</source>
        <translation>Показать текст с диска; «Отменить» вернёт ваш</translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation>Оставить моё</translation>
    </message>
    <message>
        <source>Go on with the text of the editor; saving replaces the file</source>
        <translation>Продолжать с текстом редактора; сохранение заменит файл</translation>
    </message>
    <message>
        <source>Both texts are the same.</source>
        <translation>Оба текста одинаковы.</translation>
    </message>
    <message>
        <source>−  red: lines that stand only on the disk (%1).   +  green: lines that stand only in the editor (%2).</source>
        <translation>−  красное: строки только на диске (%1).   +  зелёное: строки только в редакторе (%2).</translation>
    </message>
</context>
<context>
    <name>isoscope::DockTabs</name>
    <message>
        <source>Panels that share this place; right-click to close one or to take it out</source>
        <translation>Панели, делящие это место; правый щелчок закрывает или выносит</translation>
    </message>
    <message>
        <source>Panels that share this place</source>
        <translation>Панели, делящие это место</translation>
    </message>
    <message>
        <source>&amp;Take Out</source>
        <translation>&amp;Вынести</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Закрыть</translation>
    </message>
</context>
<context>
    <name>isoscope::Docks</name>
    <message>
        <source>Show or hide the panel “%1”</source>
        <translation>Показать или скрыть панель «%1»</translation>
    </message>
</context>
<context>
    <name>isoscope::Document</name>
    <message>
        <source>Untitled</source>
        <translation>Без имени</translation>
    </message>
    <message>
        <source>%1 is a folder.</source>
        <translation>%1 — это папка.</translation>
    </message>
    <message>
        <source>%1 is larger than %2 MB: no scene text.</source>
        <translation>%1 больше %2 МБ: это не текст сцены.</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>Не удаётся прочитать %1: %2.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2.</source>
        <translation>Не удаётся записать %1: %2.</translation>
    </message>
</context>
<context>
    <name>isoscope::DocumentController</name>
    <message>
        <source>Scenes (*.pov *.inc *.vl *.vib);;All files (*)</source>
        <translation>Сцены (*.pov *.inc *.vl *.vib);;Все файлы (*)</translation>
    </message>
    <message>
        <source>%1 (kept)</source>
        <translation>%1 (отложен)</translation>
    </message>
    <message>
        <source>%1 has changes that are not saved.</source>
        <translation>В %1 есть несохранённые изменения.</translation>
    </message>
    <message>
        <source>The text is not saved, and it cannot be kept. %1</source>
        <translation>Текст не сохранён, и его не удаётся отложить. %1</translation>
    </message>
    <message>
        <source>The unsaved text is kept; File, Kept Texts brings it back.</source>
        <translation>Несохранённый текст отложен; его вернёт «Файл, Отложенные тексты».</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Сохранить</translation>
    </message>
    <message>
        <source>Save the text to its file, then go on</source>
        <translation>Сохранить текст в его файл и продолжить</translation>
    </message>
    <message>
        <source>Keep for Next Time</source>
        <translation>Отложить</translation>
    </message>
    <message>
        <source>Leave the file as it is; the text is offered at the next start</source>
        <translation>Оставить файл как есть; текст будет предложен при следующем запуске</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Отбросить</translation>
    </message>
    <message>
        <source>Give the changes up for good</source>
        <translation>Навсегда отказаться от изменений</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Отмена</translation>
    </message>
    <message>
        <source>Go on with this text</source>
        <translation>Продолжать с этим текстом</translation>
    </message>
    <message>
        <source>Open a scene</source>
        <translation>Открыть сцену</translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation>Сохранить сцену</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>Сохранить как…</translation>
    </message>
    <message>
        <source>Save the text under another name</source>
        <translation>Сохранить текст под другим именем</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Закрыть</translation>
    </message>
    <message>
        <source>Hide this line; the text stays here</source>
        <translation>Скрыть эту строку; текст остаётся здесь</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Сохранено: %1</translation>
    </message>
    <message>
        <source>Read again: %1</source>
        <translation>Прочитано снова: %1</translation>
    </message>
    <message>
        <source>An unsaved text was kept: %1, %2.</source>
        <translation>Отложен несохранённый текст: %1, %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n unsaved texts were kept, the last one: %1, %2.</source>
        <translation>
            <numerusform>Отложен %n несохранённый текст, последний: %1, %2.</numerusform>
            <numerusform>Отложены %n несохранённых текста, последний: %1, %2.</numerusform>
            <numerusform>Отложено %n несохранённых текстов, последний: %1, %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Bring Back</source>
        <translation>Вернуть</translation>
    </message>
    <message>
        <source>Show the last kept text in the editor</source>
        <translation>Показать последний отложенный текст в редакторе</translation>
    </message>
    <message>
        <source>Show…</source>
        <translation>Показать…</translation>
    </message>
    <message>
        <source>List the kept texts with their first lines</source>
        <translation>Список отложенных текстов с первыми строками</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Позже</translation>
    </message>
    <message>
        <source>Keep them, and ask at the next start</source>
        <translation>Оставить их и спросить при следующем запуске</translation>
    </message>
    <message>
        <source>%1 is no longer there; the text has no file now.</source>
        <translation>%1 больше нет; у текста теперь нет файла.</translation>
    </message>
</context>
<context>
    <name>isoscope::EffectsPanel</name>
    <message>
        <source>%1 ms of processor time</source>
        <translation>%1 мс процессора</translation>
    </message>
    <message>
        <source>Some light is cut short; %1</source>
        <translation>Часть света укорочена; %1</translation>
    </message>
    <message>
        <source>%1 rays, %2 evaluations</source>
        <translation>Лучей: %1, вычислений: %2</translation>
    </message>
    <message>
        <source>Cost of all stages</source>
        <translation>Стоимость всех этапов</translation>
    </message>
    <message>
        <source>While &amp;moving at most</source>
        <translation>В &amp;движении не более</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> мс</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>без предела</translation>
    </message>
    <message>
        <source>Time for a moving picture</source>
        <translation>Время на изображение в движении</translation>
    </message>
    <message>
        <source>While the view or a number moves, the dearest effects are left out until a picture takes no longer; they come back at rest</source>
        <translation>Пока движется вид или число, самые дорогие эффекты опускаются, чтобы изображение не занимало больше; в покое они возвращаются</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>Эффект</translation>
    </message>
    <message>
        <source>Rays</source>
        <translation>Лучи</translation>
    </message>
    <message>
        <source>Evaluations</source>
        <translation>Вычисления</translation>
    </message>
    <message>
        <source>CPU ms</source>
        <translation>ЦП, мс</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Почему</translation>
    </message>
    <message>
        <source>Effects of the picture</source>
        <translation>Эффекты изображения</translation>
    </message>
    <message>
        <source>What the picture is made of, and what each part has cost</source>
        <translation>Из чего состоит изображение и сколько стоила каждая часть</translation>
    </message>
    <message>
        <source>Without its mark an effect is left out of this view, never of an exported picture</source>
        <translation>Без отметки эффект опускается в этом виде, но никогда в экспорте</translation>
    </message>
    <message>
        <source>Stages of drawing, in their order</source>
        <translation>Этапы рисования по порядку</translation>
    </message>
    <message>
        <source>Rays that the effect has sent</source>
        <translation>Лучи, посланные эффектом</translation>
    </message>
    <message>
        <source>Evaluations of functions that it has caused</source>
        <translation>Вычисления функций, вызванные им</translation>
    </message>
    <message>
        <source>Processor time of all threads, in milliseconds</source>
        <translation>Время процессора всех потоков, в миллисекундах</translation>
    </message>
    <message>
        <source>What in the scene calls for it, or why nothing does</source>
        <translation>Что в сцене его требует или почему ничто</translation>
    </message>
    <message>
        <source>No picture yet</source>
        <translation>Изображения ещё нет</translation>
    </message>
    <message>
        <source>Left out of this view. %1</source>
        <translation>Опущено в этом виде. %1</translation>
    </message>
    <message>
        <source>Left out while moving. %1</source>
        <translation>Опущено в движении. %1</translation>
    </message>
    <message>
        <source>%1 roots, %2 misses</source>
        <translation>корней: %1, промахов: %2</translation>
    </message>
    <message>
        <source>, %1 not certain</source>
        <translation>, без уверенности: %1</translation>
    </message>
</context>
<context>
    <name>isoscope::EmptyTextHint</name>
    <message>
        <source>Type a formula, such as x*x + y*y + z*z - 1, or a scene</source>
        <translation>Введите формулу, например x*x + y*y + z*z - 1, или сцену</translation>
    </message>
</context>
<context>
    <name>isoscope::EvaluatePanel</name>
    <message>
        <source>The isosurface whose settings are tried.</source>
        <translation>Изоповерхность, настройки которой пробуются.</translation>
    </message>
    <message>
        <source>Try settings of evaluate, or stop</source>
        <translation>Пробовать настройки evaluate или остановить</translation>
    </message>
    <message>
        <source>Progress of the trials</source>
        <translation>Ход проб</translation>
    </message>
    <message>
        <source>How many of the settings are tried</source>
        <translation>Сколько настроек опробовано</translation>
    </message>
    <message>
        <source>Whether evaluate pays</source>
        <translation>Выгоден ли evaluate</translation>
    </message>
    <message>
        <source>Write Into the Text</source>
        <translation>Записать в текст</translation>
    </message>
    <message>
        <source>Gives the isosurface the chosen setting; Undo takes it back.</source>
        <translation>Даёт изоповерхности выбранную настройку; «Отменить» вернёт.</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Настройка</translation>
    </message>
    <message>
        <source>Evaluations per pixel</source>
        <translation>Вычислений на пиксель</translation>
    </message>
    <message>
        <source>Pixels lost or wrong</source>
        <translation>Пикселей потеряно или неверно</translation>
    </message>
    <message>
        <source>Settings that were tried</source>
        <translation>Опробованные настройки</translation>
    </message>
    <message>
        <source>Enter or a double click writes the setting into the text</source>
        <translation>Enter или двойной щелчок записывает настройку в текст</translation>
    </message>
    <message>
        <source>evaluate 0.0000, 0.00, 0.00 (pays most)__</source>
        <translation>evaluate 0.0000, 0.00, 0.00 (выгоднее всего)__</translation>
    </message>
    <message>
        <source>Evaluations per pixel__</source>
        <translation>Вычислений на пиксель__</translation>
    </message>
    <message>
        <source>%1 (pays most)</source>
        <translation>%1 (выгоднее всего)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 из %2</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Стоп</translation>
    </message>
    <message>
        <source>Measure Again</source>
        <translation>Измерить снова</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Измерить</translation>
    </message>
    <message>
        <source>End the trials</source>
        <translation>Прекратить пробы</translation>
    </message>
    <message>
        <source>Tries numbers of evaluate in a small picture of this view</source>
        <translation>Пробует числа evaluate на маленьком изображении этого вида</translation>
    </message>
    <message>
        <source>The scene has no isosurface.</source>
        <translation>В сцене нет изоповерхности.</translation>
    </message>
    <message>
        <source>Each setting is tried in a small picture of this view…</source>
        <translation>Каждая настройка пробуется на маленьком изображении этого вида…</translation>
    </message>
    <message>
        <source>What evaluate would cost and lose in this view, beside the proven max_gradient.</source>
        <translation>Сколько стоил бы и сколько терял бы evaluate в этом виде рядом с доказанным max_gradient.</translation>
    </message>
    <message>
        <source>Measured before the last change of scene or view.</source>
        <translation>Измерено до последнего изменения сцены или вида.</translation>
    </message>
    <message>
        <source>evaluate does not pay in this view.</source>
        <translation>evaluate в этом виде не выгоден.</translation>
    </message>
    <message>
        <source>evaluate saves %1 % of the evaluations in this view.</source>
        <translation>evaluate экономит %1 % вычислений в этом виде.</translation>
    </message>
    <message>
        <source>No max_gradient is proven to be enough; this evaluate loses nothing in this view.</source>
        <translation>Ни для какого max_gradient не доказано, что его достаточно; этот evaluate в этом виде ничего не теряет.</translation>
    </message>
</context>
<context>
    <name>isoscope::ExampleMenu</name>
    <message>
        <source>Open the example %1</source>
        <translation>Открыть пример %1</translation>
    </message>
</context>
<context>
    <name>isoscope::ExportController</name>
    <message>
        <source>The text shows no object to write.</source>
        <translation>В тексте нет объекта для записи.</translation>
    </message>
    <message>
        <source>The images of height fields can only be written to files.</source>
        <translation>Изображения полей высот можно записать только в файлы.</translation>
    </message>
    <message>
        <source>The scene has no isosurface to write.</source>
        <translation>В сцене нет изоповерхности для записи.</translation>
    </message>
    <message>
        <source>The isosurface is on the clipboard.</source>
        <translation>Изоповерхность в буфере обмена.</translation>
    </message>
    <message>
        <source>Write the objects</source>
        <translation>Записать объекты</translation>
    </message>
    <message>
        <source>Write the isosurface</source>
        <translation>Записать изоповерхность</translation>
    </message>
    <message>
        <source>Write a scene for POV-Ray</source>
        <translation>Записать сцену для POV-Ray</translation>
    </message>
    <message>
        <source>There is no scene to write yet.</source>
        <translation>Сцены для записи ещё нет.</translation>
    </message>
    <message>
        <source>Write the objects for VirtuaLight</source>
        <translation>Записать объекты для VirtuaLight</translation>
    </message>
    <message>
        <source>VirtuaLight files (*%1);;All files (*)</source>
        <translation>Файлы VirtuaLight (*%1);;Все файлы (*)</translation>
    </message>
    <message>
        <source>POV-Ray files (*%1);;All files (*)</source>
        <translation>Файлы POV-Ray (*%1);;Все файлы (*)</translation>
    </message>
    <message>
        <source>%1 is the scene itself; an export needs a name of its own.</source>
        <translation>%1 — это сама сцена; экспорту нужно своё имя.</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Записано: %1</translation>
    </message>
    <message>
        <source>No export of Isoscope made %1.</source>
        <translation>%1 сделан не экспортом Isoscope.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Заменить</translation>
    </message>
    <message>
        <source>What stands in the file now is lost</source>
        <translation>То, что сейчас в файле, пропадёт</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Оставить</translation>
    </message>
    <message>
        <source>Write nothing</source>
        <translation>Ничего не записывать</translation>
    </message>
    <message>
        <source>There is no picture to export yet.</source>
        <translation>Изображения для экспорта ещё нет.</translation>
    </message>
    <message>
        <source>There is no text that POV-Ray could draw.</source>
        <translation>Нет текста, который мог бы нарисовать POV-Ray.</translation>
    </message>
    <message>
        <source>POV-Ray reads its own language only; File ▸ Export writes it.</source>
        <translation>POV-Ray читает только свой язык; его пишет Файл ▸ Экспорт.</translation>
    </message>
    <message>
        <source>Not given to POV-Ray: %1.</source>
        <translation>Не передано POV-Ray: %1.</translation>
    </message>
    <message>
        <source>There is no picture to copy yet.</source>
        <translation>Изображения для копирования ещё нет.</translation>
    </message>
    <message>
        <source>The picture is on the clipboard.</source>
        <translation>Изображение в буфере обмена.</translation>
    </message>
    <message>
        <source>The text has errors, or there is none.</source>
        <translation>В тексте ошибки, или его нет.</translation>
    </message>
    <message>
        <source>There is no timeline to write. The panel “Timeline” makes one.</source>
        <translation>Нет шкалы времени для записи. Её создаёт панель «Шкала времени».</translation>
    </message>
    <message>
        <source>Write an animation for POV-Ray</source>
        <translation>Записать анимацию для POV-Ray</translation>
    </message>
    <message>
        <source>%1 is no export of Isoscope; choose another name.</source>
        <translation>%1 — не экспорт Isoscope; выберите другое имя.</translation>
    </message>
    <message>
        <source>There is no isosurface to export.</source>
        <translation>Нет изоповерхности для экспорта.</translation>
    </message>
    <message>
        <source>There is no view to write yet.</source>
        <translation>Вида для записи ещё нет.</translation>
    </message>
    <message>
        <source>A camera can only be written into a text for POV-Ray.</source>
        <translation>Камеру можно записать только в текст для POV-Ray.</translation>
    </message>
    <message>
        <source>The camera stands in an include file, which is not changed.</source>
        <translation>Камера записана во включаемом файле, он не меняется.</translation>
    </message>
    <message>
        <source>The view is the camera of the text now.</source>
        <translation>Вид теперь — камера текста.</translation>
    </message>
    <message>
        <source>No bound is proven (so far): there is no comment of it.</source>
        <translation>Граница (пока) не доказана: комментария нет.</translation>
    </message>
</context>
<context>
    <name>isoscope::ExternalChanges</name>
    <message>
        <source>See the Difference</source>
        <translation>Показать различия</translation>
    </message>
    <message>
        <source>Show the lines in which the disk and the editor differ</source>
        <translation>Показать строки, в которых диск и редактор расходятся</translation>
    </message>
    <message>
        <source>Another program changed %1.</source>
        <translation>Другая программа изменила %1.</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Перечитать</translation>
    </message>
    <message>
        <source>Show what stands on the disk now</source>
        <translation>Показать то, что сейчас на диске</translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation>Не обращать внимания</translation>
    </message>
    <message>
        <source>Go on with the text as it is here; saving asks again</source>
        <translation>Продолжать с текстом как здесь; при сохранении будет новый вопрос</translation>
    </message>
    <message>
        <source>Not saved: another program changed %1 meanwhile.</source>
        <translation>Не сохранено: другая программа тем временем изменила %1.</translation>
    </message>
    <message>
        <source>Another program changed %1, and so did you.</source>
        <translation>%1 изменили и другая программа, и вы.</translation>
    </message>
    <message>
        <source>Take Theirs</source>
        <translation>Взять чужое</translation>
    </message>
    <message>
        <source>Show what stands on the disk now; Undo brings your text back</source>
        <translation>Показать то, что сейчас на диске; «Отменить» вернёт ваш текст</translation>
    </message>
    <message>
        <source>Save Mine</source>
        <translation>Сохранить моё</translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation>Оставить моё</translation>
    </message>
    <message>
        <source>Replace the file by the text of the editor</source>
        <translation>Заменить файл текстом редактора</translation>
    </message>
    <message>
        <source>Go on with your text; saving replaces the file</source>
        <translation>Продолжать с вашим текстом; сохранение заменит файл</translation>
    </message>
    <message>
        <source>Not Now</source>
        <translation>Не сейчас</translation>
    </message>
    <message>
        <source>Change nothing, neither here nor on the disk</source>
        <translation>Ничего не менять, ни здесь, ни на диске</translation>
    </message>
    <message>
        <source>Not saved: %1 is no longer there.</source>
        <translation>Не сохранено: %1 больше нет.</translation>
    </message>
    <message>
        <source>%1 is no longer there; its text stands only here.</source>
        <translation>%1 больше нет; его текст только здесь.</translation>
    </message>
    <message>
        <source>Write It Again</source>
        <translation>Записать снова</translation>
    </message>
    <message>
        <source>Save the text under its old name</source>
        <translation>Сохранить текст под прежним именем</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>Сохранить как…</translation>
    </message>
    <message>
        <source>Save the text under another name</source>
        <translation>Сохранить текст под другим именем</translation>
    </message>
    <message>
        <source>Leave the file away; the text counts as unsaved</source>
        <translation>Не писать файл; текст считается несохранённым</translation>
    </message>
</context>
<context>
    <name>isoscope::FileWriter</name>
    <message>
        <source>The text writes to files beside the scene: %1</source>
        <translation>Текст пишет файлы рядом со сценой: %1</translation>
    </message>
    <message>
        <source>Allow</source>
        <translation>Разрешить</translation>
    </message>
    <message>
        <source>Write these files now, and again when they change, until the text is closed</source>
        <translation>Записать эти файлы сейчас и снова при их изменении, пока текст не закрыт</translation>
    </message>
    <message>
        <source>The text would replace %1, which this scene did not write.</source>
        <translation>Текст заменил бы %1, а его записала не эта сцена.</translation>
    </message>
    <message>
        <source>Replace %1</source>
        <translation>Заменить %1</translation>
    </message>
    <message>
        <source>What stands in the file now is lost</source>
        <translation>То, что сейчас в файле, пропадёт</translation>
    </message>
    <message>
        <source>The text adds to %1, each time it is read.</source>
        <translation>Текст дописывает в %1 при каждом чтении.</translation>
    </message>
    <message>
        <source>Add Once</source>
        <translation>Дописать раз</translation>
    </message>
    <message>
        <source>Write to the file once more</source>
        <translation>Записать в файл ещё раз</translation>
    </message>
    <message>
        <source>The text writes %1. Save the scene first: files are written beside it only.</source>
        <translation>Текст пишет %1. Сначала сохраните сцену: файлы пишутся только рядом с ней.</translation>
    </message>
    <message>
        <source>Not Now</source>
        <translation>Не сейчас</translation>
    </message>
    <message>
        <source>Write nothing; #read and #include of the same text find it all the same</source>
        <translation>Ничего не писать; #read и #include того же текста всё равно это найдут</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Записано: %1</translation>
    </message>
    <message>
        <source>Not written: %1 (%2)</source>
        <translation>Не записано: %1 (%2)</translation>
    </message>
</context>
<context>
    <name>isoscope::FindBar</name>
    <message>
        <source>Find and replace</source>
        <translation>Найти и заменить</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Найти</translation>
    </message>
    <message>
        <source>What to look for. Enter: next, Shift+Enter: previous</source>
        <translation>Что искать. Enter: дальше, Shift+Enter: назад</translation>
    </message>
    <message>
        <source>Upper and lower case differ</source>
        <translation>Различать большие и малые буквы</translation>
    </message>
    <message>
        <source>Match case</source>
        <translation>Регистр</translation>
    </message>
    <message>
        <source>Whole words only</source>
        <translation>Только целые слова</translation>
    </message>
    <message>
        <source>Whole words</source>
        <translation>Целые слова</translation>
    </message>
    <message>
        <source>Regular expression; \1 in the replacement is the first group</source>
        <translation>Регулярное выражение; \1 в замене — первая группа</translation>
    </message>
    <message>
        <source>Regular expression</source>
        <translation>Регулярное выражение</translation>
    </message>
    <message>
        <source>Number of matches</source>
        <translation>Число совпадений</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 из %2</translation>
    </message>
    <message>
        <source>Previous match (Shift+F3)</source>
        <translation>Предыдущее совпадение (Shift+F3)</translation>
    </message>
    <message>
        <source>Previous match</source>
        <translation>Предыдущее совпадение</translation>
    </message>
    <message>
        <source>Next match (F3)</source>
        <translation>Следующее совпадение (F3)</translation>
    </message>
    <message>
        <source>Next match</source>
        <translation>Следующее совпадение</translation>
    </message>
    <message>
        <source>Close (Escape)</source>
        <translation>Закрыть (Escape)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Закрыть</translation>
    </message>
    <message>
        <source>Replace with</source>
        <translation>Заменить на</translation>
    </message>
    <message>
        <source>What to put in its place. Enter replaces the match</source>
        <translation>Что поставить взамен. Enter заменяет совпадение</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Заменить</translation>
    </message>
    <message>
        <source>Replaces the selected match and goes to the next</source>
        <translation>Заменяет выделенное совпадение и идёт к следующему</translation>
    </message>
    <message>
        <source>Replace all</source>
        <translation>Заменить всё</translation>
    </message>
    <message>
        <source>Replaces every match; one undo brings them back</source>
        <translation>Заменяет все совпадения; одна отмена вернёт их</translation>
    </message>
    <message>
        <source>Invalid</source>
        <translation>Неверно</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Нет</translation>
    </message>
    <message>
        <source>%1 found</source>
        <translation>Найдено: %1</translation>
    </message>
    <message>
        <source>Matches in the text</source>
        <translation>Совпадения в тексте</translation>
    </message>
    <message>
        <source>The regular expression is not valid: %1</source>
        <translation>Неверное регулярное выражение: %1</translation>
    </message>
    <message>
        <source>%1 replaced</source>
        <translation>Заменено: %1</translation>
    </message>
    <message>
        <source>expression is too complex</source>
        <translation>выражение слишком сложно</translation>
    </message>
</context>
<context>
    <name>isoscope::FormulaOffer</name>
    <message>
        <source>Make It an Isosurface</source>
        <translation>Сделать изоповерхностью</translation>
    </message>
    <message>
        <source>A formula shows nothing by itself. As an isosurface it can be seen.</source>
        <translation>Сама формула ничего не показывает. Как изоповерхность её видно.</translation>
    </message>
    <message>
        <source>Replace the formula by its isosurface; Undo brings it back</source>
        <translation>Заменить формулу её изоповерхностью; «Отменить» вернёт её</translation>
    </message>
    <message>
        <source>Not Now</source>
        <translation>Не сейчас</translation>
    </message>
    <message>
        <source>Leave the text as it is</source>
        <translation>Оставить текст как есть</translation>
    </message>
</context>
<context>
    <name>isoscope::FormulaPanel</name>
    <message>
        <source>no infinite slope</source>
        <translation>без бесконечной крутизны</translation>
    </message>
    <message>
        <source>no overflow</source>
        <translation>без переполнения</translation>
    </message>
    <message>
        <source>%1 times as exact</source>
        <translation>точнее в %1 раз</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>точно</translation>
    </message>
    <message>
        <source>%1 % less time</source>
        <translation>на %1 % меньше времени</translation>
    </message>
    <message>
        <source>no seam</source>
        <translation>без шва</translation>
    </message>
    <message>
        <source>the same operations</source>
        <translation>те же операции</translation>
    </message>
    <message>
        <source>proven</source>
        <translation>доказано</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>измерено</translation>
    </message>
    <message>
        <source>The isosurface whose function is written otherwise.</source>
        <translation>Изоповерхность, функция которой записывается иначе.</translation>
    </message>
    <message>
        <source>What the chosen rewrite does, and how sure that is</source>
        <translation>Что даёт выбранная запись и насколько это достоверно</translation>
    </message>
    <message>
        <source>Progress of the search for rewrites</source>
        <translation>Ход поиска других записей</translation>
    </message>
    <message>
        <source>How much of the search is done</source>
        <translation>Какая часть поиска сделана</translation>
    </message>
    <message>
        <source>Search or stop</source>
        <translation>Искать или остановить</translation>
    </message>
    <message>
        <source>Could be written as</source>
        <translation>Можно записать как</translation>
    </message>
    <message>
        <source>Gain in POV-Ray</source>
        <translation>Выигрыш в POV-Ray</translation>
    </message>
    <message>
        <source>Certainty</source>
        <translation>Достоверность</translation>
    </message>
    <message>
        <source>Other ways to write the function</source>
        <translation>Другие записи функции</translation>
    </message>
    <message>
        <source>Choose one to read what it does; Enter or a double click writes it</source>
        <translation>Выберите запись, чтобы прочитать, что она даёт; Enter или двойной щелчок записывает её</translation>
    </message>
    <message>
        <source>Rewrite</source>
        <translation>Переписать</translation>
    </message>
    <message>
        <source>Changes the text so; Undo takes it back.</source>
        <translation>Изменяет текст так; «Отменить» вернёт.</translation>
    </message>
    <message>
        <source>Write the chosen rewrite into the text</source>
        <translation>Записать выбранный вариант в текст</translation>
    </message>
    <message>
        <source>Derivatives as POV-Ray&apos;s text</source>
        <translation>Производные как текст POV-Ray</translation>
    </message>
    <message>
        <source>The derivatives in x, y and z, the length of the gradient, and a function with the same surface whose gradient is 1 on it</source>
        <translation>Производные по x, y и z, длина градиента и функция с той же поверхностью, градиент которой на ней равен 1</translation>
    </message>
    <message>
        <source>Copy Derivatives</source>
        <translation>Копировать производные</translation>
    </message>
    <message>
        <source>Puts the declarations on the clipboard.</source>
        <translation>Помещает объявления в буфер обмена.</translation>
    </message>
    <message>
        <source>The derivatives are on the clipboard.</source>
        <translation>Производные в буфере обмена.</translation>
    </message>
    <message>
        <source>Insert Derivatives</source>
        <translation>Вставить производные</translation>
    </message>
    <message>
        <source>Writes the declarations in front of the isosurface; Undo takes it back.</source>
        <translation>Записывает объявления перед изоповерхностью; «Отменить» вернёт.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Стоп</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Искать</translation>
    </message>
    <message>
        <source>End the search</source>
        <translation>Прекратить поиск</translation>
    </message>
    <message>
        <source>Look for other ways to write the function</source>
        <translation>Искать другие записи функции</translation>
    </message>
    <message>
        <source>The scene has no isosurface.</source>
        <translation>В сцене нет изоповерхности.</translation>
    </message>
    <message>
        <source>Being found out…</source>
        <translation>Выясняется…</translation>
    </message>
    <message>
        <source>It is found out once nothing moves.</source>
        <translation>Выяснится, как только всё будет в покое.</translation>
    </message>
    <message>
        <source>There is no rewrite that pays.</source>
        <translation>Выгодной другой записи нет.</translation>
    </message>
    <message>
        <source>Choose a rewrite to read what it does, and how sure that is.</source>
        <translation>Выберите запись, чтобы прочитать, что она даёт и насколько это достоверно.</translation>
    </message>
</context>
<context>
    <name>isoscope::FrameWriter</name>
    <message>
        <source>Frame %1: %2</source>
        <translation>Кадр %1: %2</translation>
    </message>
</context>
<context>
    <name>isoscope::FunctionBrowser</name>
    <message>
        <source>Parameter</source>
        <translation>Параметр</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Обычно</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Диапазон</translation>
    </message>
    <message>
        <source>&lt;tr&gt;&lt;td&gt;%1&amp;nbsp;&amp;nbsp;&lt;/td&gt;&lt;td&gt;%2&amp;nbsp;&amp;nbsp;&lt;/td&gt;&lt;td&gt;%3 to %4&lt;/td&gt;&lt;/tr&gt;</source>
        <translation>&lt;tr&gt;&lt;td&gt;%1&amp;nbsp;&amp;nbsp;&lt;/td&gt;&lt;td&gt;%2&amp;nbsp;&amp;nbsp;&lt;/td&gt;&lt;td&gt;от %3 до %4&lt;/td&gt;&lt;/tr&gt;</translation>
    </message>
    <message>
        <source>Functions</source>
        <translation>Функции</translation>
    </message>
    <message>
        <source>Search functions</source>
        <translation>Поиск функций</translation>
    </message>
    <message>
        <source>Words of the name or of parameters. Down goes to the list, Enter inserts</source>
        <translation>Слова имени или параметров. Вниз — к списку, Enter вставляет</translation>
    </message>
    <message>
        <source>Double-click or Enter inserts an isosurface of the function</source>
        <translation>Двойной щелчок или Enter вставляет изоповерхность функции</translation>
    </message>
    <message>
        <source>No function matches the search.</source>
        <translation>Нет функций по этому запросу.</translation>
    </message>
    <message>
        <source>About the function</source>
        <translation>О функции</translation>
    </message>
    <message>
        <source>Formula and parameters of the selected function</source>
        <translation>Формула и параметры выбранной функции</translation>
    </message>
    <message>
        <source>Insert isosurface</source>
        <translation>Вставить изоповерхность</translation>
    </message>
    <message>
        <source>Writes a whole isosurface that shows the function, beside what is there (Enter)</source>
        <translation>Пишет целую изоповерхность с этой функцией рядом с тем, что есть (Enter)</translation>
    </message>
    <message>
        <source>Insert call</source>
        <translation>Вставить вызов</translation>
    </message>
    <message>
        <source>Writes just the call at the caret (Shift+Enter)</source>
        <translation>Пишет у курсора только вызов (Shift+Enter)</translation>
    </message>
</context>
<context>
    <name>isoscope::GalleryController</name>
    <message>
        <source>Two shapes with a blend between them, and what each number does.</source>
        <translation>Две формы с переходом между ними, и что делает каждое число.</translation>
    </message>
    <message>
        <source>What a wrong max_gradient does to POV-Ray&apos;s picture.</source>
        <translation>Что делает с изображением POV-Ray неверный max_gradient.</translation>
    </message>
    <message>
        <source>A box whose cross-section turns with its height.</source>
        <translation>Брус, сечение которого поворачивается с высотой.</translation>
    </message>
    <message>
        <source>The product of two functions melts their surfaces.</source>
        <translation>Произведение двух функций сплавляет их поверхности.</translation>
    </message>
    <message>
        <source>A polynomial of the sixth degree.</source>
        <translation>Многочлен шестой степени.</translation>
    </message>
    <message>
        <source>Noise added to a ball makes a stone of it.</source>
        <translation>Шум, добавленный к шару, делает из него камень.</translation>
    </message>
    <message>
        <source>A height for every place, from f_ridged_mf.</source>
        <translation>Высота в каждом месте, из f_ridged_mf.</translation>
    </message>
    <message>
        <source>Sines and cosines that part space into two halves.</source>
        <translation>Синусы и косинусы, делящие пространство пополам.</translation>
    </message>
    <message>
        <source>A surface without inside or outside.</source>
        <translation>Поверхность без внутри и снаружи.</translation>
    </message>
    <message>
        <source>VirtuaLight: union, intersection and the rest.</source>
        <translation>VirtuaLight: объединение, пересечение и прочее.</translation>
    </message>
    <message>
        <source>VirtuaLight: surfaces that it knows by name.</source>
        <translation>VirtuaLight: поверхности, известные ему по именам.</translation>
    </message>
    <message>
        <source>VirtuaLight: polynomials by their coefficients.</source>
        <translation>VirtuaLight: многочлены по коэффициентам.</translation>
    </message>
    <message>
        <source>VirtuaLight: formulas of your own.</source>
        <translation>VirtuaLight: собственные формулы.</translation>
    </message>
    <message>
        <source>The text could not be kept in your collection.</source>
        <translation>Не удалось сохранить текст в вашей коллекции.</translation>
    </message>
    <message>
        <source>Added to your collection.</source>
        <translation>Добавлено в вашу коллекцию.</translation>
    </message>
    <message>
        <source>“%1” could not be removed.</source>
        <translation>Не удалось убрать «%1».</translation>
    </message>
    <message>
        <source>“%1” is removed from your collection.</source>
        <translation>«%1» убрано из вашей коллекции.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Отменить</translation>
    </message>
    <message>
        <source>Put it back into your collection</source>
        <translation>Вернуть в вашу коллекцию</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Закрыть</translation>
    </message>
    <message>
        <source>Leave it removed</source>
        <translation>Оставить убранным</translation>
    </message>
    <message>
        <source>“%1” could not be renamed.</source>
        <translation>Не удалось переименовать «%1».</translation>
    </message>
    <message>
        <source>Renamed to “%1”.</source>
        <translation>Теперь это «%1».</translation>
    </message>
</context>
<context>
    <name>isoscope::GalleryModel</name>
    <message>
        <source>Function</source>
        <translation>Функция</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Узор</translation>
    </message>
    <message>
        <source>Example</source>
        <translation>Пример</translation>
    </message>
    <message>
        <source>POV-Ray</source>
        <translation>POV-Ray</translation>
    </message>
    <message>
        <source>My collection</source>
        <translation>Моя коллекция</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Урок</translation>
    </message>
</context>
<context>
    <name>isoscope::GalleryPanel</name>
    <message>
        <source>Gallery</source>
        <translation>Галерея</translation>
    </message>
    <message>
        <source>Search the gallery</source>
        <translation>Поиск в галерее</translation>
    </message>
    <message>
        <source>Words of title, sentence or kind. Down goes to the list, Enter opens</source>
        <translation>Слова заглавия, описания или вида. Вниз — к списку, Enter открывает</translation>
    </message>
    <message>
        <source>A click or Enter opens the scene</source>
        <translation>Щелчок или Enter открывает сцену</translation>
    </message>
    <message>
        <source>Scenes of the gallery</source>
        <translation>Сцены галереи</translation>
    </message>
    <message>
        <source>No scene matches the search.</source>
        <translation>Нет сцен по этому запросу.</translation>
    </message>
    <message>
        <source>Add to My Collection</source>
        <translation>В мою коллекцию</translation>
    </message>
    <message>
        <source>Keep the open text in the gallery</source>
        <translation>Сохранить открытый текст в галерее</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Откры&amp;ть</translation>
    </message>
    <message>
        <source>&amp;Insert Isosurface</source>
        <translation>&amp;Вставить изоповерхность</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>&amp;Переименовать</translation>
    </message>
    <message>
        <source>&amp;Remove from My Collection</source>
        <translation>&amp;Убрать из моей коллекции</translation>
    </message>
</context>
<context>
    <name>isoscope::GradientPanel</name>
    <message>
        <source>The isosurface whose gradient is measured.</source>
        <translation>Изоповерхность, градиент которой измеряется.</translation>
    </message>
    <message>
        <source>On the surface</source>
        <translation>На поверхности</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Взять</translation>
    </message>
    <message>
        <source>Writes the suggested max_gradient into the text.</source>
        <translation>Пишет предложенный max_gradient в текст.</translation>
    </message>
    <message>
        <source>Use the suggested max_gradient</source>
        <translation>Взять предложенный max_gradient</translation>
    </message>
    <message>
        <source>Writes the value that is enough for this view into the text.</source>
        <translation>Пишет в текст значение, достаточное для этого вида.</translation>
    </message>
    <message>
        <source>Use the max_gradient that is enough for this view</source>
        <translation>Взять max_gradient, достаточный для этого вида</translation>
    </message>
    <message>
        <source>Go There</source>
        <translation>Туда</translation>
    </message>
    <message>
        <source>Shows the steepest place of the function in the picture.</source>
        <translation>Показывает самое крутое место функции на изображении.</translation>
    </message>
    <message>
        <source>Show the steepest place in the picture</source>
        <translation>Показать самое крутое место на изображении</translation>
    </message>
    <message>
        <source>max_gradient</source>
        <translation>max_gradient</translation>
    </message>
    <message>
        <source>How steep POV-Ray takes the function to be: the number in the text, and what it is worth. Where the function is steeper, POV-Ray steps over the surface, which leaves holes.</source>
        <translation>Насколько крутой POV-Ray считает функцию: число из текста и чего оно стоит. Где функция круче, POV-Ray перешагивает поверхность, и остаются дыры.</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Дыры</translation>
    </message>
    <message>
        <source>Pixels of this view that POV-Ray&apos;s picture gets wrong with the present setting: lost, gained, or found at a wrong place.</source>
        <translation>Пиксели этого вида, неверные в изображении POV-Ray при нынешней настройке: потерянные, лишние или не на месте.</translation>
    </message>
    <message>
        <source>Along rays</source>
        <translation>Вдоль лучей</translation>
    </message>
    <message>
        <source>How steep the function is along the rays of this view: the steepest slope that POV-Ray meets, and reports.</source>
        <translation>Насколько крута функция вдоль лучей этого вида: наибольший наклон, который POV-Ray встречает и сообщает.</translation>
    </message>
    <message>
        <source>How steep the function is where you see the surface: the largest gradient at its visible points.</source>
        <translation>Насколько крута функция там, где видна поверхность: наибольший градиент в её видимых точках.</translation>
    </message>
    <message>
        <source>Proven</source>
        <translation>Доказано</translation>
    </message>
    <message>
        <source>How steep the function gets anywhere in its container. The largest gradient lies between these: the first is reached at the place shown, the second nowhere exceeded.</source>
        <translation>Насколько крута функция где-либо в контейнере. Наибольший градиент между этими числами: первое достигается в показанном месте, второе нигде не превышено.</translation>
    </message>
    <message>
        <source>Suggested</source>
        <translation>Предложено</translation>
    </message>
    <message>
        <source>What to write for a picture without holes from every side: the smallest round value that no gradient in the container exceeds.</source>
        <translation>Что записать для изображения без дыр со всех сторон: наименьшее круглое значение, которое градиент в контейнере не превышает.</translation>
    </message>
    <message>
        <source>This view</source>
        <translation>Этот вид</translation>
    </message>
    <message>
        <source>What is enough for the present view, and faster: the smallest value that loses no pixel of it. Nothing is proven for other views.</source>
        <translation>Что достаточно для нынешнего вида и быстрее: наименьшее значение, не теряющее ни пикселя. Для других видов ничего не доказано.</translation>
    </message>
    <message>
        <source>What to do about an infinite gradient</source>
        <translation>Что делать с бесконечным градиентом</translation>
    </message>
    <message>
        <source>none in %1 pixels</source>
        <translation>нет в %1 пикселях</translation>
    </message>
    <message>
        <source>%1 lost, %2 gained, %3 at a wrong place, of %4 pixels</source>
        <translation>потеряно %1, лишних %2, не на месте %3, из %4 пикселей</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 в %2</translation>
    </message>
    <message>
        <source>%1: enough for this view, not proven for others</source>
        <translation>%1: хватает для этого вида, для других не доказано</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>, tightening</source>
        <translation>, уточняется</translation>
    </message>
    <message>
        <source>, budget spent</source>
        <translation>, предел работы исчерпан</translation>
    </message>
    <message>
        <source>unbounded: %1 at %2</source>
        <translation>не ограничен: %1 в %2</translation>
    </message>
    <message>
        <source>%1 to %2%3, the first at %4</source>
        <translation>от %1 до %2%3, первое в %4</translation>
    </message>
    <message>
        <source>%1: enough but for jumps</source>
        <translation>%1: хватает, кроме скачков</translation>
    </message>
    <message>
        <source>%1: proven for every view</source>
        <translation>%1: доказано для всех видов</translation>
    </message>
    <message>
        <source>at most %1 so far</source>
        <translation>пока не более %1</translation>
    </message>
    <message>
        <source>The scene has no isosurface to measure.</source>
        <translation>В сцене нет изоповерхности для измерения.</translation>
    </message>
    <message>
        <source>No bound at %1: %2. %3</source>
        <translation>Нет границы в %1: %2. %3</translation>
    </message>
    <message>
        <source>Farther than %1 from such places no gradient exceeds %2.</source>
        <translation>Дальше %1 от таких мест градиент не превышает %2.</translation>
    </message>
    <message>
        <source>Beside jumps no gradient exceeds %1.</source>
        <translation>Вне скачков градиент не превышает %1.</translation>
    </message>
    <message>
        <source>The bound holds beside places where the function may jump; none was found.</source>
        <translation>Граница верна вне мест, где функция может скакать; таких не найдено.</translation>
    </message>
    <message>
        <source>At the mouse</source>
        <translation>Под мышью</translation>
    </message>
    <message>
        <source>How steep the function is at the point under the mouse, in the picture, the cross-section or a chart, beside max_gradient.</source>
        <translation>Насколько крута функция в точке под мышью — на изображении, в сечении или на графике — рядом с max_gradient.</translation>
    </message>
    <message>
        <source>f is undefined</source>
        <translation>f не определена</translation>
    </message>
    <message>
        <source>infinite</source>
        <translation>бесконечность</translation>
    </message>
    <message>
        <source>%1: %2 % of max_gradient</source>
        <translation>%1: %2 % от max_gradient</translation>
    </message>
</context>
<context>
    <name>isoscope::HelpBrowser</name>
    <message>
        <source>Page of the help</source>
        <translation>Страница справки</translation>
    </message>
</context>
<context>
    <name>isoscope::HelpController</name>
    <message>
        <source>Help</source>
        <translation>Справка</translation>
    </message>
    <message>
        <source>&lt;p&gt;Lessons, and pages about the language, the functions and the window. F1 opens the one about what has the focus.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Уроки и страницы о языке, функциях и окне. F1 открывает страницу о том, что в фокусе.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>isoscope::HelpPanel</name>
    <message>
        <source>Help</source>
        <translation>Справка</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Назад</translation>
    </message>
    <message>
        <source>To the page before (Alt+Left)</source>
        <translation>К предыдущей странице (Alt+Влево)</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Вперёд</translation>
    </message>
    <message>
        <source>To the next page (Alt+Right)</source>
        <translation>К следующей странице (Alt+Вправо)</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Содержание</translation>
    </message>
    <message>
        <source>The list of all pages</source>
        <translation>Список всех страниц</translation>
    </message>
    <message>
        <source>Search the help</source>
        <translation>Поиск в справке</translation>
    </message>
    <message>
        <source>Words that stand on a page. Down goes to the list, Enter opens</source>
        <translation>Слова со страницы. Вниз — к списку, Enter открывает</translation>
    </message>
    <message>
        <source>Pages of the help</source>
        <translation>Страницы справки</translation>
    </message>
    <message>
        <source>A click or Enter opens the page</source>
        <translation>Щелчок или Enter открывает страницу</translation>
    </message>
    <message>
        <source>No page has all these words.</source>
        <translation>Нет страницы со всеми этими словами.</translation>
    </message>
    <message>
        <source>Find on this page</source>
        <translation>Найти на странице</translation>
    </message>
    <message>
        <source>Enter goes to the next place, Shift+Enter to the one before</source>
        <translation>Enter — к следующему месту, Shift+Enter — к предыдущему</translation>
    </message>
    <message>
        <source>Number of places</source>
        <translation>Число мест</translation>
    </message>
    <message>
        <source>Find previous</source>
        <translation>Найти предыдущее</translation>
    </message>
    <message>
        <source>To the place before</source>
        <translation>К предыдущему месту</translation>
    </message>
    <message>
        <source>Find next</source>
        <translation>Найти следующее</translation>
    </message>
    <message>
        <source>To the next place</source>
        <translation>К следующему месту</translation>
    </message>
    <message>
        <source>none</source>
        <translation>нет</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s)</source>
        <translation>
            <numerusform>%n место</numerusform>
            <numerusform>%n места</numerusform>
            <numerusform>%n мест</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>isoscope::HistogramPanel</name>
    <message>
        <source>Histogram of the gradient</source>
        <translation>Гистограмма градиента</translation>
    </message>
    <message>
        <source>How steep the function is, and how often: how much of the container, and of the surface, has which gradient |∇f|.</source>
        <translation>Насколько крута функция и как часто: какая часть контейнера и поверхности имеет какой градиент |∇f|.</translation>
    </message>
    <message>
        <source>How much is steeper than max_gradient</source>
        <translation>Сколько круче max_gradient</translation>
    </message>
    <message>
        <source>gradient</source>
        <translation>градиент</translation>
    </message>
    <message>
        <source>The gradient of the isosurface is shown here once it is measured.</source>
        <translation>Градиент изоповерхности появится здесь, когда будет измерен.</translation>
    </message>
    <message>
        <source>in the container</source>
        <translation>в контейнере</translation>
    </message>
    <message>
        <source>on the surface</source>
        <translation>на поверхности</translation>
    </message>
    <message>
        <source>max_gradient %1</source>
        <translation>max_gradient %1</translation>
    </message>
    <message>
        <source>attained %1</source>
        <translation>достигнуто %1</translation>
    </message>
    <message>
        <source>proven %1</source>
        <translation>доказано %1</translation>
    </message>
    <message>
        <source>0 to %1: %2</source>
        <translation>от 0 до %1: %2</translation>
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
        <translation>Распределение градиента</translation>
    </message>
    <message>
        <source>Steeper than max_gradient: %1 of the container, %2 of the surface.</source>
        <translation>Круче max_gradient: %1 контейнера, %2 поверхности.</translation>
    </message>
    <message>
        <source>Steeper than max_gradient: %1 of the container. No surface was met.</source>
        <translation>Круче max_gradient: %1 контейнера. Поверхность не встретилась.</translation>
    </message>
    <message>
        <source> Infinite at %1 samples.</source>
        <translation> Бесконечен в %1 отсчётах.</translation>
    </message>
</context>
<context>
    <name>isoscope::ImageExportDialog</name>
    <message>
        <source>Export image</source>
        <translation>Экспорт изображения</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Ход работы</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Результат</translation>
    </message>
    <message>
        <source>Width of the image</source>
        <translation>Ширина изображения</translation>
    </message>
    <message>
        <source>Height of the image</source>
        <translation>Высота изображения</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Размер</translation>
    </message>
    <message>
        <source>Keep the proportions</source>
        <translation>Сохранять пропорции</translation>
    </message>
    <message>
        <source>Width and height follow each other, so that the picture shows what the window shows</source>
        <translation>Ширина и высота следуют друг за другом, чтобы изображение показывало то же, что окно</translation>
    </message>
    <message>
        <source>Smooth edges (anti-aliasing)</source>
        <translation>Гладкие края (сглаживание)</translation>
    </message>
    <message>
        <source>Several rays for pixels on edges; takes longer</source>
        <translation>Несколько лучей на пиксели краёв; это дольше</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>Прозрачный фон</translation>
    </message>
    <message>
        <source>Leave out background and sky where no object hides them; the file says how much shows through</source>
        <translation>Опустить фон и небо там, где их не закрывает объект; файл хранит, сколько просвечивает</translation>
    </message>
    <message>
        <source>The file to write: .png for an image, .exr for OpenEXR with layers</source>
        <translation>Записываемый файл: .png — изображение, .exr — OpenEXR со слоями</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Файл</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Выбрать…</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>Выбрать файл</translation>
    </message>
    <message>
        <source>PNG, 8 bits a channel</source>
        <translation>PNG, 8 бит на канал</translation>
    </message>
    <message>
        <source>PNG, 16 bits a channel</source>
        <translation>PNG, 16 бит на канал</translation>
    </message>
    <message>
        <source>16 bits keep steps of light that 8 bits round away, in files of twice the size</source>
        <translation>16 бит хранят ступени света, которые 8 бит округляют; файлы вдвое больше</translation>
    </message>
    <message>
        <source>OpenEXR: colour, opacity, distance, normals, verdicts</source>
        <translation>OpenEXR: цвет, непрозрачность, расстояние, нормали, заключения</translation>
    </message>
    <message>
        <source>Channels R, G, B, A; Z; N.X, N.Y, N.Z; verdict, with the exact root finder</source>
        <translation>Каналы R, G, B, A; Z; N.X, N.Y, N.Z; заключение, с точным поиском корней</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Формат</translation>
    </message>
    <message>
        <source>Render</source>
        <translation>Рисовать</translation>
    </message>
    <message>
        <source>Render the image and write it</source>
        <translation>Нарисовать изображение и записать его</translation>
    </message>
    <message>
        <source>Queue</source>
        <translation>В очередь</translation>
    </message>
    <message>
        <source>Render the image behind those that are waiting; it goes on when this is closed</source>
        <translation>Нарисовать изображение после ожидающих; продолжается и после закрытия</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Стоп</translation>
    </message>
    <message>
        <source>Stop; no file is written</source>
        <translation>Остановить; файл не пишется</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Закрыть</translation>
    </message>
    <message>
        <source>Close; an export that is waited for is stopped</source>
        <translation>Закрыть; ожидаемый экспорт останавливается</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Открыть</translation>
    </message>
    <message>
        <source>Open the image in the program for images</source>
        <translation>Открыть изображение в программе для изображений</translation>
    </message>
    <message>
        <source>Show Folder</source>
        <translation>Показать папку</translation>
    </message>
    <message>
        <source>Open the folder that holds the image</source>
        <translation>Открыть папку с изображением</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Заменить</translation>
    </message>
    <message>
        <source>%1 exists already. Replace it?</source>
        <translation>%1 уже есть. Заменить?</translation>
    </message>
    <message>
        <source>PNG images (*.png)</source>
        <translation>Картинки PNG (*.png)</translation>
    </message>
    <message>
        <source>OpenEXR images (*.exr)</source>
        <translation>Картинки OpenEXR (*.exr)</translation>
    </message>
    <message>
        <source>Please choose a file.</source>
        <translation>Выберите файл.</translation>
    </message>
    <message>
        <source>The file exists and is no PNG or OpenEXR picture: it is not replaced.</source>
        <translation>Файл существует и не картинка PNG или OpenEXR: он не заменяется.</translation>
    </message>
    <message>
        <source>%1 is in the queue. Pictures on the way: %2</source>
        <translation>%1 в очереди. Изображений в работе: %2</translation>
    </message>
    <message>
        <source>Waits for other pictures…</source>
        <translation>Ждёт других изображений…</translation>
    </message>
    <message>
        <source>Rendering…</source>
        <translation>Рисуется…</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Записано: %1</translation>
    </message>
    <message>
        <source>How long the picture will take with all cores of this computer: squares of it are drawn to find out. POV-Ray&apos;s time follows from the function and what its method evaluates.</source>
        <translation>Сколько времени займёт изображение на всех ядрах этого компьютера: для этого рисуются его квадраты. Время POV-Ray следует из функции и из того, что вычисляет его метод.</translation>
    </message>
    <message>
        <source>How long the picture will take</source>
        <translation>Сколько времени займёт изображение</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Время</translation>
    </message>
</context>
<context>
    <name>isoscope::IncludeFoldersDialog</name>
    <message>
        <source>Include folders</source>
        <translation>Папки включений</translation>
    </message>
    <message>
        <source>#include looks beside the scene first, then in these folders, from the top, then in those of an installed POV-Ray.</source>
        <translation>#include ищет сперва рядом со сценой, потом в этих папках сверху вниз, потом в папках установленного POV-Ray.</translation>
    </message>
    <message>
        <source>Folders in the order in which they are searched; drag to change it</source>
        <translation>Папки в порядке поиска; перетащите, чтобы изменить его</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Добавить…</translation>
    </message>
    <message>
        <source>Add a folder</source>
        <translation>Добавить папку</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Убрать</translation>
    </message>
    <message>
        <source>Remove the selected folder from the list</source>
        <translation>Убрать выбранную папку из списка</translation>
    </message>
    <message>
        <source>Use these folders</source>
        <translation>Использовать эти папки</translation>
    </message>
    <message>
        <source>Leave the folders as they were</source>
        <translation>Оставить папки как были</translation>
    </message>
    <message>
        <source>Add an include folder</source>
        <translation>Добавить папку включений</translation>
    </message>
</context>
<context>
    <name>isoscope::IncludeViewer</name>
    <message>
        <source>Close</source>
        <translation>Закрыть</translation>
    </message>
    <message>
        <source>Close the include file (Esc)</source>
        <translation>Закрыть включаемый файл (Esc)</translation>
    </message>
    <message>
        <source>Close the include file</source>
        <translation>Закрыть включаемый файл</translation>
    </message>
    <message>
        <source>Include file, read only</source>
        <translation>Включаемый файл, только чтение</translation>
    </message>
    <message>
        <source>%1 – read only</source>
        <translation>%1 – только чтение</translation>
    </message>
</context>
<context>
    <name>isoscope::InsertionController</name>
    <message>
        <source>VirtuaLight&apos;s notation does not know POV-Ray&apos;s functions.</source>
        <translation>Язык VirtuaLight не знает функций POV-Ray.</translation>
    </message>
</context>
<context>
    <name>isoscope::KeptTextsWindow</name>
    <message>
        <source>Kept texts</source>
        <translation>Отложенные тексты</translation>
    </message>
    <message>
        <source>First lines of the text</source>
        <translation>Первые строки текста</translation>
    </message>
    <message>
        <source>Bring Back</source>
        <translation>Вернуть</translation>
    </message>
    <message>
        <source>Show this text in the editor</source>
        <translation>Показать этот текст в редакторе</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Отбросить</translation>
    </message>
    <message>
        <source>Delete this text for good</source>
        <translation>Удалить этот текст навсегда</translation>
    </message>
    <message>
        <source>Discard All</source>
        <translation>Отбросить все</translation>
    </message>
    <message>
        <source>Delete all kept texts for good</source>
        <translation>Удалить все отложенные тексты навсегда</translation>
    </message>
    <message>
        <source>Discard All %1 for Good</source>
        <translation>Отбросить все %1 навсегда</translation>
    </message>
    <message>
        <source>There are no kept texts.</source>
        <translation>Отложенных текстов нет.</translation>
    </message>
    <message>
        <source>Texts that were never saved. Each stays here until it is saved or discarded, for %1 days at least.</source>
        <translation>Тексты, которые не были сохранены. Каждый остаётся здесь, пока не сохранён или отброшен, не менее %1 дней.</translation>
    </message>
    <message>
        <source>Never had a file</source>
        <translation>Файла не было</translation>
    </message>
</context>
<context>
    <name>isoscope::LinkedProbe</name>
    <message>
        <source>undefined</source>
        <translation>не определена</translation>
    </message>
    <message>
        <source>infinite</source>
        <translation>бесконечность</translation>
    </message>
    <message>
        <source>x %1, y %2, z %3: %4</source>
        <translation>x %1, y %2, z %3: %4</translation>
    </message>
    <message>
        <source>f is undefined</source>
        <translation>f не определена</translation>
    </message>
    <message>
        <source>f %1, |∇f| %2</source>
        <translation>f %1, |∇f| %2</translation>
    </message>
    <message>
        <source>%1, distance %2</source>
        <translation>%1, расстояние %2</translation>
    </message>
</context>
<context>
    <name>isoscope::MainWindow</name>
    <message>
        <source>Another window could not be opened.</source>
        <translation>Не удалось открыть ещё одно окно.</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Текст</translation>
    </message>
    <message>
        <source>&lt;p&gt;The text of the scene, in POV-Ray&apos;s language. The picture follows while you type; signs in the margin tell what is wrong and whether surfaces have holes.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Текст сцены на языке POV-Ray. Изображение следует за вводом; знаки на полях говорят, что неверно и есть ли у поверхностей дыры.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Параметры</translation>
    </message>
    <message>
        <source>&lt;p&gt;A slider for every number of the text that can be moved. Moving it writes the number.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Ползунок для каждого числа текста, которое можно двигать. Движение пишет число в текст.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Functions</source>
        <translation>Функции</translation>
    </message>
    <message>
        <source>&lt;p&gt;The functions that can be inserted, with pictures.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Функции, которые можно вставить, с изображениями.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Проблемы</translation>
    </message>
    <message>
        <source>&lt;p&gt;What is wrong with the text, what is not shown of it, and which isosurfaces have holes in POV-Ray. Click a line to go there; buttons mend what can be mended.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Что неверно в тексте, что из него не показано и у каких изоповерхностей в POV-Ray дыры. Щёлкните строку, чтобы перейти туда; кнопки исправляют, что можно исправить.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Gallery</source>
        <translation>Галерея</translation>
    </message>
    <message>
        <source>&lt;p&gt;Functions, examples, POV-Ray&apos;s snippets and your own scenes. A click opens one.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Функции, примеры, фрагменты POV-Ray и свои сцены. Щелчок открывает.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Шкала времени</translation>
    </message>
    <message>
        <source>&lt;p&gt;The frames of an animation, and the keys of numbers and view that make them. All of it is kept in comments of the text.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Кадры анимации и ключи чисел и вида, из которых они получаются. Всё хранится в комментариях текста.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Инструменты</translation>
    </message>
    <message>
        <source>Place of the caret in the text</source>
        <translation>Место курсора в тексте</translation>
    </message>
    <message>
        <source>Place of the caret</source>
        <translation>Место курсора</translation>
    </message>
    <message>
        <source>Line %1, column %2</source>
        <translation>Строка %1, столбец %2</translation>
    </message>
    <message>
        <source>The text is newer than the picture; saving or F5 shows it.</source>
        <translation>Текст новее изображения; его покажет сохранение или F5.</translation>
    </message>
    <message>
        <source>The language changes at the next start.</source>
        <translation>Язык сменится при следующем запуске.</translation>
    </message>
    <message>
        <source>%1 – Isoscope</source>
        <translation>%1 – Isoscope</translation>
    </message>
    <message>
        <source>The point under the mouse in the picture, the cross-section or a chart, in the coordinates of its function, with f and its gradient</source>
        <translation>Точка под мышью на изображении, в сечении или на графике, в координатах её функции, с f и её градиентом</translation>
    </message>
    <message>
        <source>The probed point</source>
        <translation>Точка под мышью</translation>
    </message>
</context>
<context>
    <name>isoscope::MeshExportDialog</name>
    <message>
        <source>Export mesh</source>
        <translation>Экспорт сетки</translation>
    </message>
    <message>
        <source>The notation of the file; its ending follows</source>
        <translation>Формат файла; окончание имени следует за ним</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Формат</translation>
    </message>
    <message>
        <source>a 500th of the container</source>
        <translation>500-я часть контейнера</translation>
    </message>
    <message>
        <source>How far mesh and surface may be apart, in units of the scene</source>
        <translation>Насколько могут расходиться сетка и поверхность, в единицах сцены</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Допуск</translation>
    </message>
    <message>
        <source>Colours of the texture</source>
        <translation>Цвета текстуры</translation>
    </message>
    <message>
        <source>A colour for each vertex, where the format has colours</source>
        <translation>Цвет каждой вершины, если формат знает цвета</translation>
    </message>
    <message>
        <source>The file to write</source>
        <translation>Записываемый файл</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Файл</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Выбрать…</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>Выбрать файл</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Ход работы</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Результат</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Экспорт</translation>
    </message>
    <message>
        <source>Make the mesh and write it</source>
        <translation>Построить сетку и записать её</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Стоп</translation>
    </message>
    <message>
        <source>Stop; no file is written</source>
        <translation>Остановить; файл не пишется</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Закрыть</translation>
    </message>
    <message>
        <source>Close; a running export is stopped</source>
        <translation>Закрыть; идущий экспорт останавливается</translation>
    </message>
    <message>
        <source>Show Folder</source>
        <translation>Показать папку</translation>
    </message>
    <message>
        <source>Open the folder that holds the mesh</source>
        <translation>Открыть папку с сеткой</translation>
    </message>
    <message>
        <source>Meshes (*.stl *.3mf *.obj *.ply *.glb *.inc)</source>
        <translation>Сетки (*.stl *.3mf *.obj *.ply *.glb *.inc)</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Заменить</translation>
    </message>
    <message>
        <source>%1 exists already. Replace it?</source>
        <translation>%1 уже есть. Заменить?</translation>
    </message>
    <message>
        <source>Please choose a file.</source>
        <translation>Выберите файл.</translation>
    </message>
    <message>
        <source>The tolerance is a positive number, or empty.</source>
        <translation>Допуск — положительное число или пусто.</translation>
    </message>
    <message>
        <source>The file exists and is no mesh of Isoscope: it is not replaced.</source>
        <translation>Файл существует и не сетка Isoscope: он не заменяется.</translation>
    </message>
    <message>
        <source>Looking for the surface…</source>
        <translation>Ищется поверхность…</translation>
    </message>
    <message>
        <source>Stopped; nothing was written.</source>
        <translation>Остановлено; ничего не записано.</translation>
    </message>
    <message>
        <source>No mesh: %1.</source>
        <translation>Сетки нет: %1.</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Останавливается…</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Записано: %1</translation>
    </message>
</context>
<context>
    <name>isoscope::NoticeBar</name>
    <message>
        <source>Notice</source>
        <translation>Сообщение</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Закрыть</translation>
    </message>
    <message>
        <source>Hide this line</source>
        <translation>Скрыть эту строку</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <comment>notices</comment>
        <translation>
            <numerusform>ещё %n</numerusform>
            <numerusform>ещё %n</numerusform>
            <numerusform>ещё %n</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>isoscope::NumberPopup</name>
    <message>
        <source>Slider for the number at the caret</source>
        <translation>Ползунок для числа у курсора</translation>
    </message>
    <message>
        <source>Enter keeps the number, Esc brings the first one back</source>
        <translation>Enter оставляет число, Esc возвращает прежнее</translation>
    </message>
</context>
<context>
    <name>isoscope::NumberTool</name>
    <message>
        <source>Slider for the number at the caret</source>
        <translation>Ползунок для числа у курсора</translation>
    </message>
    <message>
        <source>Change this number with a slider</source>
        <translation>Изменить это число ползунком</translation>
    </message>
    <message>
        <source>There is no number at the caret.</source>
        <translation>У курсора нет числа.</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Число</translation>
    </message>
</context>
<context>
    <name>isoscope::OverlayBar</name>
    <message>
        <source>What the overlay shows</source>
        <translation>Что показывает наложение</translation>
    </message>
    <message>
        <source>Counted in the pixels of this picture, with the settings of the text</source>
        <translation>Посчитано по пикселям этого изображения, с настройками текста</translation>
    </message>
    <message>
        <source>Progress of the overlay</source>
        <translation>Ход наложения</translation>
    </message>
    <message>
        <source>How much of the overlay is computed</source>
        <translation>Какая часть наложения вычислена</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Стоп</translation>
    </message>
    <message>
        <source>Stop computing the overlay</source>
        <translation>Прекратить вычисление наложения</translation>
    </message>
</context>
<context>
    <name>isoscope::OverlayButton</name>
    <message>
        <source>What is laid over the picture: holes of POV-Ray&apos;s method, or the gradient</source>
        <translation>Что наложено на изображение: дыры метода POV-Ray или градиент</translation>
    </message>
    <message>
        <source>Overlay of the picture</source>
        <translation>Наложение на изображение</translation>
    </message>
</context>
<context>
    <name>isoscope::ParameterBinding</name>
    <message>
        <source>Kept until the file is closed: the text can only keep it for the last number of a line</source>
        <translation>Хранится, пока файл открыт: текст может хранить это только для последнего числа строки</translation>
    </message>
</context>
<context>
    <name>isoscope::ParameterGroup</name>
    <message>
        <source>Show or hide the parameters of %1</source>
        <translation>Показать или скрыть параметры %1</translation>
    </message>
</context>
<context>
    <name>isoscope::ParameterPanel</name>
    <message>
        <source>Filter parameters</source>
        <translation>Фильтр параметров</translation>
    </message>
    <message>
        <source>Shows only parameters whose name or function contains these words</source>
        <translation>Показывает только параметры, в имени или функции которых есть эти слова</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Параметры</translation>
    </message>
    <message>
        <source>Numbers of the scene. A double click on a name brings its first value back</source>
        <translation>Числа сцены. Двойной щелчок по имени возвращает первое значение</translation>
    </message>
    <message>
        <source>Randomise</source>
        <translation>Случайно</translation>
    </message>
    <message>
        <source>Random values for the numbers listed here; locked ones, containers, accuracy and max_gradient stay</source>
        <translation>Случайные значения для чисел списка; запертые, контейнеры, accuracy и max_gradient остаются</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Сбросить все</translation>
    </message>
    <message>
        <source>Brings the first values of the numbers listed here back; locked ones stay</source>
        <translation>Возвращает первые значения чисел списка; запертые остаются</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Прочее</translation>
    </message>
    <message>
        <source>, lines %1 to %2</source>
        <translation>, строки %1–%2</translation>
    </message>
    <message>
        <source>, line %1</source>
        <translation>, строка %1</translation>
    </message>
    <message>
        <source>Nothing to move yet.
Numbers of function calls, #declare, threshold, accuracy, max_gradient and contained_by appear here.</source>
        <translation>Двигать пока нечего.
Здесь появляются числа из вызовов функций, #declare, threshold, accuracy, max_gradient и contained_by.</translation>
    </message>
    <message>
        <source>No parameter matches the filter.</source>
        <translation>Нет параметров по этому фильтру.</translation>
    </message>
    <message numerus="yes">
        <source>%n more number(s) are not shown; drag them in the text with Ctrl.</source>
        <translation>
            <numerusform>Ещё %n число не показано; тяните его в тексте с Ctrl.</numerusform>
            <numerusform>Ещё %n числа не показаны; тяните их в тексте с Ctrl.</numerusform>
            <numerusform>Ещё %n чисел не показано; тяните их в тексте с Ctrl.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>isoscope::ParameterSlider</name>
    <message>
        <source>More</source>
        <translation>Ещё</translation>
    </message>
    <message>
        <source>Replace by number</source>
        <translation>Заменить числом</translation>
    </message>
    <message>
        <source>%1 (default)</source>
        <translation>%1 (обычное)</translation>
    </message>
    <message>
        <source>%1 (x, y and z)</source>
        <translation>%1 (x, y и z)</translation>
    </message>
    <message>
        <source>%1 is the expression %2</source>
        <translation>%1 — это выражение %2</translation>
    </message>
    <message>
        <source>Expression of %1</source>
        <translation>Выражение %1</translation>
    </message>
    <message>
        <source>Writes %1 in place of the expression, which gives it a slider</source>
        <translation>Пишет %1 вместо выражения, и появляется ползунок</translation>
    </message>
    <message>
        <source>Replace the expression of %1 by a number</source>
        <translation>Заменить выражение %1 числом</translation>
    </message>
    <message>
        <source>%1 is not in the text; moving the slider writes it</source>
        <translation>%1 нет в тексте; движение ползунка запишет его</translation>
    </message>
    <message>
        <source>%1. Double-click: back to %2</source>
        <translation>%1. Двойной щелчок: назад к %2</translation>
    </message>
    <message>
        <source>%1, from %2 to %3</source>
        <translation>%1, от %2 до %3</translation>
    </message>
    <message>
        <source>There can be a surface from %1 to %2, the green part; for no other value of the slider, all else as it is</source>
        <translation>Поверхность возможна от %1 до %2, зелёная часть; ни при каком другом значении ползунка, если прочее неизменно</translation>
    </message>
    <message>
        <source>There is no surface for any value of the slider, all else as it is</source>
        <translation>Ни при каком значении ползунка поверхности нет, если прочее неизменно</translation>
    </message>
    <message>
        <source>%1, slider</source>
        <translation>%1, ползунок</translation>
    </message>
    <message>
        <source>Value of %1</source>
        <translation>Значение %1</translation>
    </message>
    <message>
        <source>Lower end of the slider. Double-click to change it</source>
        <translation>Нижний край ползунка. Двойной щелчок меняет его</translation>
    </message>
    <message>
        <source>Upper end of the slider. Double-click to change it</source>
        <translation>Верхний край ползунка. Двойной щелчок меняет его</translation>
    </message>
    <message>
        <source>Lower end of %1</source>
        <translation>Нижний край %1</translation>
    </message>
    <message>
        <source>Upper end of %1</source>
        <translation>Верхний край %1</translation>
    </message>
    <message>
        <source>Stop (Esc)</source>
        <translation>Стоп (Esc)</translation>
    </message>
    <message>
        <source>Play: moves %1 by itself, until Esc or a touch of the slider</source>
        <translation>Пуск: само движет %1, до Esc или касания ползунка</translation>
    </message>
    <message>
        <source>Stop %1</source>
        <translation>Остановить %1</translation>
    </message>
    <message>
        <source>Play %1</source>
        <translation>Пустить %1</translation>
    </message>
    <message>
        <source>%1 is locked. Click to move it again</source>
        <translation>%1 заперт. Щёлкните, чтобы снова двигать</translation>
    </message>
    <message>
        <source>Unlock %1</source>
        <translation>Отпереть %1</translation>
    </message>
    <message>
        <source>Range, step, lock and more of %1</source>
        <translation>Диапазон, шаг, замок и прочее для %1</translation>
    </message>
    <message>
        <source>Menu of %1</source>
        <translation>Меню %1</translation>
    </message>
    <message>
        <source>Back to %1</source>
        <translation>Назад к %1</translation>
    </message>
    <message>
        <source>The value that the text had when it was opened</source>
        <translation>Значение, которое было в тексте при открытии</translation>
    </message>
    <message>
        <source>Random value</source>
        <translation>Случайное значение</translation>
    </message>
    <message>
        <source>Any value of the slider</source>
        <translation>Любое значение ползунка</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Заперт</translation>
    </message>
    <message>
        <source>The slider does not move, nor does a preset or Randomise move it</source>
        <translation>Ползунок не двигается, и ни набор, ни «Случайно» его не двигают</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Пуск</translation>
    </message>
    <message>
        <source>Set key at this frame</source>
        <translation>Поставить ключ на этом кадре</translation>
    </message>
    <message>
        <source>The timeline keeps the present value, in a comment of the text</source>
        <translation>Шкала времени хранит нынешнее значение в комментарии текста</translation>
    </message>
    <message>
        <source>Range, step and scale…</source>
        <translation>Диапазон, шаг и шкала…</translation>
    </message>
    <message>
        <source>How the slider moves; kept in the text, in a comment behind the number</source>
        <translation>Как движется ползунок; хранится в тексте, в комментарии за числом</translation>
    </message>
    <message>
        <source>Usual range</source>
        <translation>Обычный диапазон</translation>
    </message>
    <message>
        <source>Takes the comment about the slider out of the text</source>
        <translation>Убирает из текста комментарий о ползунке</translation>
    </message>
    <message>
        <source>Enter sets the end, Escape leaves it</source>
        <translation>Enter задаёт край, Escape оставляет его</translation>
    </message>
    <message>
        <source>Back and forth</source>
        <translation>Туда и обратно</translation>
    </message>
    <message>
        <source>Turns round at each end</source>
        <translation>Поворачивает на каждом краю</translation>
    </message>
    <message>
        <source>Round and round</source>
        <translation>По кругу</translation>
    </message>
    <message>
        <source>Begins at the lower end again</source>
        <translation>Снова начинает с нижнего края</translation>
    </message>
    <message>
        <source>Once</source>
        <translation>Один раз</translation>
    </message>
    <message>
        <source>Stops at the upper end</source>
        <translation>Останавливается на верхнем краю</translation>
    </message>
    <message>
        <source>%1 s from end to end</source>
        <translation>%1 с от края до края</translation>
    </message>
    <message>
        <source>How fast it plays</source>
        <translation>Как быстро это идёт</translation>
    </message>
</context>
<context>
    <name>isoscope::PictureForecast</name>
    <message>
        <source>0.1 s or less</source>
        <translation>0.1 с или меньше</translation>
    </message>
    <message>
        <source>Being measured…</source>
        <translation>Измеряется…</translation>
    </message>
    <message>
        <source>Here about %1 (±%2 %)</source>
        <translation>Здесь около %1 (±%2 %)</translation>
    </message>
    <message>
        <source>, POV-Ray without smooth edges about %1 (±%2 %)</source>
        <translation>, POV-Ray без гладких краёв около %1 (±%2 %)</translation>
    </message>
    <message>
        <source>, POV-Ray about %1 (±%2 %)</source>
        <translation>, POV-Ray около %1 (±%2 %)</translation>
    </message>
</context>
<context>
    <name>isoscope::PictureQueue</name>
    <message>
        <source>%1 could not be written: %2.</source>
        <translation>Не удалось записать %1: %2.</translation>
    </message>
    <message>
        <source>Stopped; nothing was written.</source>
        <translation>Остановлено; ничего не записано.</translation>
    </message>
</context>
<context>
    <name>isoscope::PictureQueueWindow</name>
    <message>
        <source>Pictures in the making</source>
        <translation>Изображения в работе</translation>
    </message>
    <message>
        <source>No picture is on the way. File ▸ Export ▸ Image… puts them here by its button “Queue”.</source>
        <translation>Изображений в работе нет. Файл ▸ Экспорт ▸ Изображение… помещает их сюда кнопкой «В очередь».</translation>
    </message>
    <message>
        <source>Stop All</source>
        <translation>Остановить все</translation>
    </message>
    <message>
        <source>Stop every picture that is not written yet</source>
        <translation>Остановить все ещё не записанные изображения</translation>
    </message>
    <message>
        <source>Clear List</source>
        <translation>Очистить список</translation>
    </message>
    <message>
        <source>Take the pictures off the list that are written or stopped; files stay</source>
        <translation>Убрать из списка записанные и остановленные изображения; файлы остаются</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Закрыть</translation>
    </message>
    <message>
        <source>Close; pictures go on</source>
        <translation>Закрыть; изображения продолжаются</translation>
    </message>
    <message>
        <source>%1, %2 × %3</source>
        <translation>%1, %2 × %3</translation>
    </message>
    <message>
        <source>Progress of %1</source>
        <translation>Ход %1</translation>
    </message>
    <message>
        <source>Open %1 in the program for images</source>
        <translation>Открыть %1 в программе для изображений</translation>
    </message>
    <message>
        <source>Stop %1</source>
        <translation>Остановить %1</translation>
    </message>
</context>
<context>
    <name>isoscope::PictureRoom</name>
    <message>
        <source>&amp;Fold the Panels Below</source>
        <translation>&amp;Свернуть нижние панели</translation>
    </message>
    <message>
        <source>Leave of the panels below the picture only their tabs; a click on a tab unfolds them</source>
        <translation>Оставить от панелей под изображением только вкладки; щелчок по вкладке разворачивает их</translation>
    </message>
    <message>
        <source>Unfold the panels below</source>
        <translation>Развернуть нижние панели</translation>
    </message>
    <message>
        <source>Fold the panels below</source>
        <translation>Свернуть нижние панели</translation>
    </message>
</context>
<context>
    <name>isoscope::PresetController</name>
    <message>
        <source>Presets</source>
        <translation>Наборы</translation>
    </message>
    <message>
        <source>Presets: named sets of values, kept in the text</source>
        <translation>Наборы: именованные значения, хранимые в тексте</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>Имя набора</translation>
    </message>
    <message>
        <source>Enter keeps the preset under this name, Esc leaves it</source>
        <translation>Enter сохраняет набор под этим именем, Esc — нет</translation>
    </message>
    <message>
        <source>Sets the numbers to those of this preset; locked ones stay</source>
        <translation>Ставит числа, как в этом наборе; запертые остаются</translation>
    </message>
    <message>
        <source>New preset…</source>
        <translation>Новый набор…</translation>
    </message>
    <message>
        <source>Keeps the present values under a name, in a comment of the text</source>
        <translation>Сохраняет нынешние значения под именем в комментарии текста</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>Обновить</translation>
    </message>
    <message>
        <source>The preset takes the present values</source>
        <translation>Набор берёт нынешние значения</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Переименовать</translation>
    </message>
    <message>
        <source>Another name for the preset</source>
        <translation>Другое имя для набора</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Удалить</translation>
    </message>
    <message>
        <source>Takes the preset out of the text</source>
        <translation>Убирает набор из текста</translation>
    </message>
    <message>
        <source>Preset “%1” is set.</source>
        <translation>Набор «%1» поставлен.</translation>
    </message>
    <message>
        <source>Locked and left as they are: %1.</source>
        <translation>Заперты и оставлены: %1.</translation>
    </message>
    <message>
        <source>Not in the text: %1.</source>
        <translation>Нет в тексте: %1.</translation>
    </message>
    <message>
        <source>Preset %1</source>
        <translation>Набор %1</translation>
    </message>
    <message>
        <source>A preset needs a name.</source>
        <translation>Набору нужно имя.</translation>
    </message>
    <message>
        <source>There is a preset “%1” already.</source>
        <translation>Набор «%1» уже есть.</translation>
    </message>
</context>
<context>
    <name>isoscope::PreviewLight</name>
    <message>
        <source>An object has no pigment: POV-Ray shows it black.</source>
        <translation>У объекта нет pigment: POV-Ray показывает его чёрным.</translation>
    </message>
    <message>
        <source>Light It in the Preview</source>
        <translation>Осветить в просмотре</translation>
    </message>
    <message>
        <source>Show it in grey here; the text, exports and POV-Ray&apos;s picture stay black</source>
        <translation>Показать его здесь серым; текст, экспорт и изображение POV-Ray остаются чёрными</translation>
    </message>
    <message>
        <source>Leave It Black</source>
        <translation>Оставить чёрным</translation>
    </message>
    <message>
        <source>Problems offers to add a pigment</source>
        <translation>«Проблемы» предлагают добавить pigment</translation>
    </message>
</context>
<context>
    <name>isoscope::ProblemsPanel</name>
    <message>
        <source>Error</source>
        <translation>Ошибка</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Предупреждение</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Опущено</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Замечание</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Сообщение</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Место</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Проблемы</translation>
    </message>
    <message>
        <source>What is wrong with the text, and what of it is not shown. Enter goes to the place</source>
        <translation>Что неверно в тексте и что из него не показано. Enter переходит к месту</translation>
    </message>
    <message>
        <source>No problems. Everything in the text is shown.</source>
        <translation>Проблем нет. Показано всё, что есть в тексте.</translation>
    </message>
    <message>
        <source>%1 (%2 times)</source>
        <translation>%1 (%2 раз)</translation>
    </message>
    <message>
        <source>Change the text so; Undo takes it back</source>
        <translation>Изменить текст так; «Отменить» вернёт</translation>
    </message>
    <message>
        <source>Fix All %1</source>
        <translation>Исправить все %1</translation>
    </message>
    <message>
        <source>Do the same for every problem of this kind, as one step</source>
        <translation>Сделать то же для всех проблем этого рода за один шаг</translation>
    </message>
    <message>
        <source>Copy Message</source>
        <translation>Копировать сообщение</translation>
    </message>
    <message>
        <source>error</source>
        <translation>ошибка</translation>
    </message>
    <message>
        <source>errors</source>
        <translation>ошибки</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>предупреждение</translation>
    </message>
    <message>
        <source>warnings</source>
        <translation>предупреждения</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>опущено</translation>
    </message>
    <message>
        <source>note</source>
        <translation>замечание</translation>
    </message>
    <message>
        <source>notes</source>
        <translation>замечания</translation>
    </message>
    <message>
        <source>Problems: %1</source>
        <translation>Проблемы: %1</translation>
    </message>
</context>
<context>
    <name>isoscope::QuickFixer</name>
    <message>
        <source>The text has changed there.</source>
        <translation>Текст там изменился.</translation>
    </message>
    <message>
        <source>: done.</source>
        <translation>: сделано.</translation>
    </message>
    <message>
        <source>%1 changes made.</source>
        <translation>Изменений: %1.</translation>
    </message>
</context>
<context>
    <name>isoscope::RayPanel</name>
    <message>
        <source>The isosurface that is shown along the ray.</source>
        <translation>Изоповерхность, показанная вдоль луча.</translation>
    </message>
    <message>
        <source>The one in front</source>
        <translation>Передняя</translation>
    </message>
    <message>
        <source>Cones</source>
        <translation>Конусы</translation>
    </message>
    <message>
        <source>What POV-Ray trusts: from each of its samples, how soon a function no steeper than max_gradient could reach the threshold. Between two cones that do not meet it, it looks no closer.</source>
        <translation>Чему верит POV-Ray: как скоро от каждого отсчёта функция не круче max_gradient могла бы достичь порога. Между двумя конусами, не касающимися его, он не смотрит внимательнее.</translation>
    </message>
    <message>
        <source>Show the cones of max_gradient</source>
        <translation>Показать конусы max_gradient</translation>
    </message>
    <message>
        <source>Enclosures</source>
        <translation>Оболочки</translation>
    </message>
    <message>
        <source>How the exact picture finds the surface: the pieces in which the certified root finder encloses the function.</source>
        <translation>Как находит поверхность точное изображение: отрезки, на которых сертифицированный поиск корней заключает функцию в границы.</translation>
    </message>
    <message>
        <source>Show the enclosures of the exact picture</source>
        <translation>Показать оболочки точного изображения</translation>
    </message>
    <message>
        <source>Value under the mouse</source>
        <translation>Значение под мышью</translation>
    </message>
    <message>
        <source>ray</source>
        <translation>луч</translation>
    </message>
    <message>
        <source>The function along the ray</source>
        <translation>Функция вдоль луча</translation>
    </message>
    <message>
        <source>f − threshold along the ray; wheel to zoom, drag to shift, double-click for the whole ray</source>
        <translation>f − threshold вдоль луча; колесо — масштаб, тянуть — сдвиг, двойной щелчок — весь луч</translation>
    </message>
    <message>
        <source>What happens along the ray</source>
        <translation>Что происходит вдоль луча</translation>
    </message>
    <message>
        <source>The scene has no isosurface.</source>
        <translation>В сцене нет изоповерхности.</translation>
    </message>
    <message>
        <source>Switch “Ray” on above the picture and click a pixel.</source>
        <translation>Включите «Луч» над изображением и щёлкните пиксель.</translation>
    </message>
    <message>
        <source>This ray passes the container by.</source>
        <translation>Этот луч проходит мимо контейнера.</translation>
    </message>
    <message>
        <source>f − threshold along the ray</source>
        <translation>f − threshold вдоль луча</translation>
    </message>
    <message>
        <source>f − threshold</source>
        <translation>f − threshold</translation>
    </message>
    <message>
        <source>distance from the camera</source>
        <translation>расстояние от камеры</translation>
    </message>
    <message>
        <source>surface %1</source>
        <translation>поверхность %1</translation>
    </message>
    <message>
        <source>POV-Ray %1</source>
        <translation>POV-Ray %1</translation>
    </message>
    <message>
        <source>enclosure</source>
        <translation>оболочка</translation>
    </message>
    <message>
        <source>POV-Ray&apos;s samples</source>
        <translation>отсчёты POV-Ray</translation>
    </message>
    <message>
        <source>dismissed</source>
        <translation>отброшено</translation>
    </message>
    <message>
        <source>dismissed wrongly</source>
        <translation>отброшено ошибочно</translation>
    </message>
    <message>
        <source>at %1: %2</source>
        <translation>в %1: %2</translation>
    </message>
    <message>
        <source>undefined</source>
        <translation>не определена</translation>
    </message>
</context>
<context>
    <name>isoscope::ReadingBar</name>
    <message>
        <source>Progress of reading</source>
        <translation>Ход чтения</translation>
    </message>
    <message>
        <source>Where in the text is being read; loops lead back</source>
        <translation>Какое место текста читается; циклы ведут назад</translation>
    </message>
    <message>
        <source>Place in the text</source>
        <translation>Место в тексте</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Стоп</translation>
    </message>
    <message>
        <source>End the reading of this text; what was shown before stays</source>
        <translation>Прекратить чтение этого текста; показанное раньше остаётся</translation>
    </message>
    <message>
        <source>Stop reading</source>
        <translation>Прекратить чтение</translation>
    </message>
    <message>
        <source>Reading the text: %1 s, %2 steps</source>
        <translation>Чтение текста: %1 с, шагов: %2</translation>
    </message>
</context>
<context>
    <name>isoscope::RecentFiles</name>
    <message>
        <source>No files yet</source>
        <translation>Файлов ещё нет</translation>
    </message>
    <message>
        <source>Clear list</source>
        <translation>Очистить список</translation>
    </message>
    <message>
        <source>Forget these files; nothing is deleted</source>
        <translation>Забыть эти файлы; ничего не удаляется</translation>
    </message>
</context>
<context>
    <name>isoscope::RecoveryStore</name>
    <message>
        <source>Unsaved text cannot be kept in %1: %2.</source>
        <translation>Несохранённый текст не удаётся отложить в %1: %2.</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>папку не удаётся создать</translation>
    </message>
    <message>
        <source>its lock cannot be taken</source>
        <translation>её замок не удаётся взять</translation>
    </message>
</context>
<context>
    <name>isoscope::RepairPanel</name>
    <message>
        <source>line %1</source>
        <translation>строка %1</translation>
    </message>
    <message>
        <source>%1, %2 times</source>
        <translation>%1, %2 раз</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>не менее %1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>нет</translation>
    </message>
    <message>
        <source>%1 times as long</source>
        <translation>в %1 раза дольше</translation>
    </message>
    <message>
        <source>Isosurface</source>
        <translation>Изоповерхность</translation>
    </message>
    <message>
        <source>Proven</source>
        <translation>Доказано</translation>
    </message>
    <message>
        <source>To write</source>
        <translation>Записать</translation>
    </message>
    <message>
        <source>Wrong pixels</source>
        <translation>Неверные пиксели</translation>
    </message>
    <message>
        <source>POV-Ray takes</source>
        <translation>POV-Ray считает</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Вердикт</translation>
    </message>
    <message>
        <source>Isosurfaces of the scene and its include files</source>
        <translation>Изоповерхности сцены и её файлов include</translation>
    </message>
    <message>
        <source>What is ticked is written by the button below; a double click, or Enter, shows the place</source>
        <translation>Отмеченное записывает кнопка внизу; двойной щелчок или Enter показывает место</translation>
    </message>
    <message>
        <source>include_file.inc:1000, 100 times_____</source>
        <translation>include_file.inc:1000, 100 раз_____</translation>
    </message>
    <message>
        <source>How far the isosurfaces are judged</source>
        <translation>Насколько изоповерхности проверены</translation>
    </message>
    <message>
        <source>Progress of the proofs</source>
        <translation>Ход доказательств</translation>
    </message>
    <message>
        <source>How many isosurfaces are judged</source>
        <translation>Сколько изоповерхностей проверено</translation>
    </message>
    <message>
        <source>Stop the proofs or go on</source>
        <translation>Остановить доказательства или продолжить</translation>
    </message>
    <message>
        <source>Tick all or none</source>
        <translation>Отметить все или ничего</translation>
    </message>
    <message>
        <source>Writes what is ticked where it stands: into the text, where Undo takes it back, and into the include files in the folder of the scene; every other character stays</source>
        <translation>Записывает отмеченное на место: в текст, где это отменяет «Отменить», и в файлы include из папки сцены; все остальные знаки сохраняются</translation>
    </message>
    <message>
        <source>Write the ticked values</source>
        <translation>Записать отмеченные значения</translation>
    </message>
    <message>
        <source>The file is not changed: %1.</source>
        <translation>Файл не изменяется: %1.</translation>
    </message>
    <message>
        <source>The value cannot be written where the statement stands.</source>
        <translation>Значение нельзя записать там, где стоит оператор.</translation>
    </message>
    <message>
        <source>Go On</source>
        <translation>Продолжить</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Остановить</translation>
    </message>
    <message>
        <source>Go on with the proofs</source>
        <translation>Продолжить доказательства</translation>
    </message>
    <message>
        <source>End the proofs; what is known stays</source>
        <translation>Закончить доказательства; известное остаётся</translation>
    </message>
    <message>
        <source>The isosurfaces are being judged…</source>
        <translation>Изоповерхности проверяются…</translation>
    </message>
    <message>
        <source>The scene shows no isosurface that has a max_gradient.</source>
        <translation>В сцене не видно изоповерхностей с max_gradient.</translation>
    </message>
    <message>
        <source>%1 of %2 statements are judged.</source>
        <translation>Проверено операторов: %1 из %2.</translation>
    </message>
    <message>
        <source>There is nothing to repair.</source>
        <translation>Исправлять нечего.</translation>
    </message>
    <message>
        <source>Wrong pixels and time are those of this view; what is written is proven for every view.</source>
        <translation>Неверные пиксели и время — для этого вида; записываемое доказано для любого вида.</translation>
    </message>
    <message>
        <source>Tick All</source>
        <translation>Отметить все</translation>
    </message>
    <message>
        <source>Tick None</source>
        <translation>Снять все</translation>
    </message>
    <message>
        <source>Ticks all rows that can be written, or none</source>
        <translation>Отмечает все строки, которые можно записать, или ни одной</translation>
    </message>
    <message>
        <source>Write 1 Value</source>
        <translation>Записать 1 значение</translation>
    </message>
    <message>
        <source>Write %1 Values</source>
        <translation>Записать значений: %1</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Записать</translation>
    </message>
</context>
<context>
    <name>isoscope::ReportPanel</name>
    <message>
        <source>no value</source>
        <translation>нет значения</translation>
    </message>
    <message>
        <source>infinite, or infinitely steep</source>
        <translation>бесконечна или бесконечно крута</translation>
    </message>
    <message>
        <source>jumps by %1</source>
        <translation>скачок на %1</translation>
    </message>
    <message>
        <source>jumps</source>
        <translation>скачок</translation>
    </message>
    <message>
        <source>digits lost: off by up to %1</source>
        <translation>потеря цифр: ошибка до %1</translation>
    </message>
    <message>
        <source>kink</source>
        <translation>излом</translation>
    </message>
    <message>
        <source>The isosurface that is reported on.</source>
        <translation>Изоповерхность, о которой отчёт.</translation>
    </message>
    <message>
        <source>Report on the shape</source>
        <translation>Отчёт о форме</translation>
    </message>
    <message>
        <source>What the solid is like, each with its proof or its error</source>
        <translation>Каково тело, всё с доказательством или погрешностью</translation>
    </message>
    <message>
        <source>What the chosen place does to the pictures</source>
        <translation>Что делает выбранное место с изображениями</translation>
    </message>
    <message>
        <source>Progress of the report</source>
        <translation>Ход отчёта</translation>
    </message>
    <message>
        <source>How much of the report is done</source>
        <translation>Какая часть отчёта готова</translation>
    </message>
    <message>
        <source>Report or stop</source>
        <translation>Отчёт или остановка</translation>
    </message>
    <message>
        <source>The function has</source>
        <translation>У функции</translation>
    </message>
    <message>
        <source>From the surface</source>
        <translation>От поверхности</translation>
    </message>
    <message>
        <source>Certainty</source>
        <translation>Надёжность</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Где</translation>
    </message>
    <message>
        <source>Places where the function is not healthy</source>
        <translation>Места, где с функцией неладно</translation>
    </message>
    <message>
        <source>Go There</source>
        <translation>Туда</translation>
    </message>
    <message>
        <source>Shows the place in the picture.</source>
        <translation>Показывает место на изображении.</translation>
    </message>
    <message>
        <source>Show the chosen place in the picture</source>
        <translation>Показать выбранное место на изображении</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Стоп</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Отчёт</translation>
    </message>
    <message>
        <source>End the work</source>
        <translation>Закончить работу</translation>
    </message>
    <message>
        <source>Find out what the isosurface is like</source>
        <translation>Выяснить, какова изоповерхность</translation>
    </message>
    <message>
        <source>The scene has no isosurface.</source>
        <translation>В сцене нет изоповерхности.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Being found out…</source>
        <translation>Выясняется…</translation>
    </message>
    <message>
        <source>It is found out once nothing moves.</source>
        <translation>Выясняется, как только ничто не движется.</translation>
    </message>
    <message>
        <source>at the surface</source>
        <translation>у поверхности</translation>
    </message>
    <message>
        <source>%1 away</source>
        <translation>на %1 дальше</translation>
    </message>
    <message>
        <source>met</source>
        <translation>встречено</translation>
    </message>
    <message>
        <source>suspected</source>
        <translation>подозрение</translation>
    </message>
    <message>
        <source>The function has a value and a slope everywhere in the container, and no kink.</source>
        <translation>Функция имеет значение и наклон всюду в контейнере, изломов нет.</translation>
    </message>
    <message>
        <source>Choose a place to see it, and what it does to the pictures.</source>
        <translation>Выберите место, чтобы увидеть его и то, что оно делает с изображениями.</translation>
    </message>
    <message>
        <source>Choose a place to see it. The search ended early: there may be more.</source>
        <translation>Выберите место, чтобы увидеть его. Поиск закончен раньше: мест может быть больше.</translation>
    </message>
    <message>
        <source>Remedy</source>
        <translation>Средство</translation>
    </message>
    <message>
        <source>A click, or Enter, shows the place in the picture; a click on a remedy writes it</source>
        <translation>Щелчок или Enter показывает место на картинке; щелчок по средству записывает его</translation>
    </message>
    <message>
        <source>Rewrite</source>
        <translation>Переписать</translation>
    </message>
    <message>
        <source>Changes the text so; Undo takes it back.</source>
        <translation>Изменяет текст так; «Отменить» возвращает его.</translation>
    </message>
    <message>
        <source>Write the remedy of the chosen place into the text</source>
        <translation>Записать в текст средство для выбранного места</translation>
    </message>
    <message>
        <source>A click writes it: %1</source>
        <translation>Щелчок записывает: %1</translation>
    </message>
</context>
<context>
    <name>isoscope::SceneDisplay</name>
    <message>
        <source>The text has errors; what was understood of it is shown.</source>
        <translation>В тексте ошибки; показано то, что понятно.</translation>
    </message>
    <message>
        <source>The text has errors; the first picture, of the text before them, is under way.</source>
        <translation>В тексте ошибки; первое изображение, по тексту до них, рисуется.</translation>
    </message>
    <message>
        <source>The text has errors; this is the picture from before.</source>
        <translation>В тексте ошибки; это прежнее изображение.</translation>
    </message>
    <message>
        <source>The text has errors, listed under Problems; nothing can be shown yet.</source>
        <translation>В тексте ошибки, они в списке «Проблемы»; показать пока нечего.</translation>
    </message>
</context>
<context>
    <name>isoscope::SceneEditor</name>
    <message>
        <source>Scene text</source>
        <translation>Текст сцены</translation>
    </message>
    <message>
        <source>The scene in POV-Ray&apos;s language. Ctrl with the up and down keys changes the number at the caret.</source>
        <translation>Сцена на языке POV-Ray. Ctrl со стрелками вверх и вниз меняет число у курсора.</translation>
    </message>
    <message>
        <source>The scene&apos;s text. Drag a number with Ctrl to change it.</source>
        <translation>Текст сцены. Тяните число с Ctrl, чтобы изменить его.</translation>
    </message>
    <message>
        <source>Drag with Ctrl changes the number, a click with Ctrl opens a slider for it</source>
        <translation>Движение с Ctrl меняет число, щелчок с Ctrl открывает для него ползунок</translation>
    </message>
</context>
<context>
    <name>isoscope::SceneLexer</name>
    <message>
        <source>Text</source>
        <translation>Текст</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Комментарий</translation>
    </message>
    <message>
        <source>String</source>
        <translation>Строка</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Число</translation>
    </message>
    <message>
        <source>Directive</source>
        <translation>Директива</translation>
    </message>
    <message>
        <source>Keyword</source>
        <translation>Ключевое слово</translation>
    </message>
    <message>
        <source>Function</source>
        <translation>Функция</translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation>Символ</translation>
    </message>
</context>
<context>
    <name>isoscope::SceneRepairer</name>
    <message>
        <source>The text is still being read; nothing is changed.</source>
        <translation>Текст ещё читается; ничего не изменено.</translation>
    </message>
    <message>
        <source>%1 is not changed: %2.</source>
        <translation>%1 не изменён: %2.</translation>
    </message>
    <message>
        <source>Values of max_gradient were written into %1.</source>
        <translation>Значения max_gradient записаны в %1.</translation>
    </message>
    <message>
        <source>Put Back</source>
        <translation>Вернуть</translation>
    </message>
    <message>
        <source>Give the files the text that they had</source>
        <translation>Вернуть файлам прежний текст</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Закрыть</translation>
    </message>
    <message>
        <source>Keep the files as they are now</source>
        <translation>Оставить файлы как есть</translation>
    </message>
    <message>
        <source>Not put back, for it has changed since or cannot be written: %1.</source>
        <translation>Не возвращено: файл с тех пор изменился или не записывается: %1.</translation>
    </message>
</context>
<context>
    <name>isoscope::SectionControls</name>
    <message>
        <source>The isosurface whose function is shown</source>
        <translation>Изоповерхность, функция которой показана</translation>
    </message>
    <message>
        <source>Cut at a constant %1 (in the function&apos;s own coordinates)</source>
        <translation>Срез при постоянном %1 (в координатах самой функции)</translation>
    </message>
    <message>
        <source>Plane across the %1 axis</source>
        <translation>Плоскость поперёк оси %1</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Свободно</translation>
    </message>
    <message>
        <source>Cut by a plane of any direction: turn it by its angles, or drag it in the picture</source>
        <translation>Срез плоскостью любого направления: поверните её углами или тяните на изображении</translation>
    </message>
    <message>
        <source>Free plane</source>
        <translation>Свободная плоскость</translation>
    </message>
    <message>
        <source>Where the plane lies; the ends are the container&apos;s walls</source>
        <translation>Где лежит плоскость; края — стенки контейнера</translation>
    </message>
    <message>
        <source>Position of the plane</source>
        <translation>Положение плоскости</translation>
    </message>
    <message>
        <source>Position of the plane as a number</source>
        <translation>Положение плоскости числом</translation>
    </message>
    <message>
        <source>turn </source>
        <translation>поворот </translation>
    </message>
    <message>
        <source>Heading: how far the plane is turned about y</source>
        <translation>Поворот: насколько плоскость повёрнута вокруг y</translation>
    </message>
    <message>
        <source>Heading of the plane</source>
        <translation>Поворот плоскости</translation>
    </message>
    <message>
        <source>tilt </source>
        <translation>наклон </translation>
    </message>
    <message>
        <source>Tilt: how far the plane leans back; at 90° it lies level</source>
        <translation>Наклон: насколько плоскость отклонена назад; при 90° она горизонтальна</translation>
    </message>
    <message>
        <source>Tilt of the plane</source>
        <translation>Наклон плоскости</translation>
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
        <translation>Показанная величина</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Линии</translation>
    </message>
    <message>
        <source>Thin lines of equal value</source>
        <translation>Тонкие линии равных значений</translation>
    </message>
    <message>
        <source>Show lines of equal value</source>
        <translation>Показать линии равных значений</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Профиль</translation>
    </message>
    <message>
        <source>Chart the function along a line: drag in the section to draw one</source>
        <translation>График функции вдоль линии: проведите её в сечении</translation>
    </message>
    <message>
        <source>Profile along a line</source>
        <translation>Профиль вдоль линии</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Сохранить</translation>
    </message>
    <message>
        <source>Write the section, or its numbers, to a file</source>
        <translation>Записать сечение или его числа в файл</translation>
    </message>
    <message>
        <source>Save the section or its numbers</source>
        <translation>Сохранить сечение или его числа</translation>
    </message>
    <message>
        <source>&amp;Picture (PNG)…</source>
        <translation>&amp;Изображение (PNG)…</translation>
    </message>
    <message>
        <source>&amp;Numbers (CSV)…</source>
        <translation>&amp;Числа (CSV)…</translation>
    </message>
    <message>
        <source>P&amp;rofile</source>
        <translation>&amp;Профиль</translation>
    </message>
    <message>
        <source>The %1 of the plane</source>
        <translation>%1 плоскости</translation>
    </message>
    <message>
        <source>Distance of the plane from the middle of the container</source>
        <translation>Расстояние плоскости от середины контейнера</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>авто</translation>
    </message>
    <message>
        <source>Value with the full colour</source>
        <translation>Значение с полным цветом</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>расстояние</translation>
    </message>
    <message>
        <source>What the colours show: the function, how steep it is, or how far the surface is: (f − threshold) ÷ |∇f|, which is right near the surface</source>
        <translation>Что показывают цвета: функцию, её крутизну или расстояние до поверхности: (f − threshold) ÷ |∇f|, верное вблизи поверхности</translation>
    </message>
    <message>
        <source>What has the full colour, and by whose parts lines are drawn: the values of the function, the slope or the distance; auto: most values, or max_gradient</source>
        <translation>Чему соответствует полный цвет и по долям чего проводятся линии: значения функции, крутизна или расстояние; авто: большинство значений или max_gradient</translation>
    </message>
</context>
<context>
    <name>isoscope::SectionPanel</name>
    <message>
        <source>Value of the function under the mouse</source>
        <translation>Значение функции под мышью</translation>
    </message>
    <message>
        <source>profile</source>
        <translation>профиль</translation>
    </message>
    <message>
        <source>The container has no finite extent.</source>
        <translation>У контейнера нет конечной протяжённости.</translation>
    </message>
    <message>
        <source>The scene has no isosurface to cut.</source>
        <translation>В сцене нет изоповерхности для среза.</translation>
    </message>
    <message>
        <source>through %1 across %2</source>
        <translation>через %1 поперёк %2</translation>
    </message>
    <message>
        <source>at %1 = %2</source>
        <translation>при %1 = %2</translation>
    </message>
    <message>
        <source>|∇f| %1; up to %2 here, max_gradient is %3</source>
        <translation>|∇f| %1; здесь до %2, max_gradient равен %3</translation>
    </message>
    <message>
        <source>f − threshold %1</source>
        <translation>f − threshold %1</translation>
    </message>
    <message>
        <source>; hatched where f is undefined</source>
        <translation>; штриховка там, где f не определена</translation>
    </message>
    <message>
        <source>undefined</source>
        <translation>не определена</translation>
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
        <translation>Сохранить сечение</translation>
    </message>
    <message>
        <source>Save Numbers</source>
        <translation>Сохранить числа</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>Картинки PNG (*.png)</translation>
    </message>
    <message>
        <source>CSV tables (*.csv)</source>
        <translation>Таблицы CSV (*.csv)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Сохранено: %1.</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>Не удаётся записать %1.</translation>
    </message>
    <message>
        <source>f − threshold on the plane: blue is inside, orange outside, the bold line is the surface.
|∇f|: red where it is steeper than max_gradient.
distance: (f − threshold) ÷ |∇f|, how far the surface is, to first order.
Drag to move, wheel to zoom, double-click to see all. Hatched: f is undefined.</source>
        <translation>f − threshold на плоскости: синее внутри, оранжевое снаружи, жирная линия — поверхность.
|∇f|: красное там, где круче max_gradient.
расстояние: (f − threshold) ÷ |∇f|, расстояние до поверхности в первом приближении.
Тянуть — сдвиг, колесо — масштаб, двойной щелчок — всё целиком. Штриховка: f не определена.</translation>
    </message>
    <message>
        <source>distance to the surface %1</source>
        <translation>расстояние до поверхности %1</translation>
    </message>
    <message>
        <source>, distance = %1</source>
        <translation>, расстояние = %1</translation>
    </message>
</context>
<context>
    <name>isoscope::SectionProfile</name>
    <message>
        <source>The function along the line</source>
        <translation>Функция вдоль линии</translation>
    </message>
    <message>
        <source>The quantity of the colours along the line from A to B; the dashed lines are where it passes the threshold</source>
        <translation>Величина цветов вдоль линии от A до B; пунктир — там, где она проходит порог</translation>
    </message>
    <message>
        <source>Value along the line under the mouse</source>
        <translation>Значение на линии под мышью</translation>
    </message>
    <message>
        <source>Draw a line in the section.</source>
        <translation>Проведите линию в сечении.</translation>
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
        <translation>расстояние от A</translation>
    </message>
    <message>
        <source>Along the line from A to B</source>
        <translation>Вдоль линии от A до B</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>от %1 до %2</translation>
    </message>
    <message>
        <source>undefined</source>
        <translation>не определена</translation>
    </message>
    <message>
        <source>%1: f − threshold = %2, |∇f| = %3</source>
        <translation>%1: f − threshold = %2, |∇f| = %3</translation>
    </message>
    <message>
        <source>, distance = %1</source>
        <translation>, расстояние = %1</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>расстояние</translation>
    </message>
</context>
<context>
    <name>isoscope::SectionView</name>
    <message>
        <source>Cross-section of the function</source>
        <translation>Сечение функции</translation>
    </message>
    <message>
        <source>%1, %2 away</source>
        <translation>%1, на %2 дальше</translation>
    </message>
</context>
<context>
    <name>isoscope::SettingWriter</name>
    <message>
        <source>%1 values of max_gradient are changed.</source>
        <translation>Изменено значений max_gradient: %1.</translation>
    </message>
    <message>
        <source>The isosurface does not stand in the text itself; its %1 is not changed.</source>
        <translation>Изоповерхность записана не в самом тексте; её %1 не меняется.</translation>
    </message>
    <message>
        <source>%1 is %2 now.</source>
        <translation>%1 теперь %2.</translation>
    </message>
    <message>
        <source>The isosurface does not stand in the text itself; it is not changed.</source>
        <translation>Изоповерхность записана не в самом тексте; она не меняется.</translation>
    </message>
    <message>
        <source>The isosurface has evaluate now.</source>
        <translation>Теперь у изоповерхности есть evaluate.</translation>
    </message>
</context>
<context>
    <name>isoscope::SheetPanel</name>
    <message>
        <source>Draw the sheet, or stop</source>
        <translation>Рисовать лист или остановить</translation>
    </message>
    <message>
        <source>Progress of the sheet</source>
        <translation>Ход рисования листа</translation>
    </message>
    <message>
        <source>How many of the pictures are drawn</source>
        <translation>Сколько изображений нарисовано</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Сохранить…</translation>
    </message>
    <message>
        <source>Write the sheet to a PNG file</source>
        <translation>Записать лист в файл PNG</translation>
    </message>
    <message>
        <source>Save the sheet</source>
        <translation>Сохранить лист</translation>
    </message>
    <message>
        <source>Click a picture to set its values in the text</source>
        <translation>Щёлкните изображение, чтобы задать его значения в тексте</translation>
    </message>
    <message>
        <source>Sheet of small pictures</source>
        <translation>Лист миниатюр</translation>
    </message>
    <message>
        <source>About the sheet</source>
        <translation>О листе</translation>
    </message>
    <message>
        <source>down</source>
        <translation>вниз</translation>
    </message>
    <message>
        <source>across</source>
        <translation>вправо</translation>
    </message>
    <message>
        <source>The number whose values go down, if there is to be a second one</source>
        <translation>Число, значения которого идут вниз, если нужно второе</translation>
    </message>
    <message>
        <source>The number whose values go across</source>
        <translation>Число, значения которого идут вправо</translation>
    </message>
    <message>
        <source>from</source>
        <translation>от</translation>
    </message>
    <message>
        <source>First value</source>
        <translation>Первое значение</translation>
    </message>
    <message>
        <source>to</source>
        <translation>до</translation>
    </message>
    <message>
        <source>Last value</source>
        <translation>Последнее значение</translation>
    </message>
    <message>
        <source>Number of values</source>
        <translation>Количество значений</translation>
    </message>
    <message>
        <source>How many values are drawn</source>
        <translation>Сколько значений рисуется</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>(no second number)</source>
        <translation>(без второго числа)</translation>
    </message>
    <message>
        <source>The text is still being read, or has errors.</source>
        <translation>Текст ещё читается или содержит ошибки.</translation>
    </message>
    <message>
        <source>The sheet would be too large.</source>
        <translation>Лист был бы слишком велик.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Сохранить</translation>
    </message>
    <message>
        <source>sheet</source>
        <translation>лист</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>Картинки PNG (*.png)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Записано: %1.</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>Не удаётся записать %1.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Стоп</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Рисовать</translation>
    </message>
    <message>
        <source>End the drawing; what is drawn stays</source>
        <translation>Прекратить рисование; нарисованное остаётся</translation>
    </message>
    <message>
        <source>Draw the scene in small for each of the values</source>
        <translation>Нарисовать сцену в миниатюре для каждого из значений</translation>
    </message>
    <message>
        <source>Choose one number, or two, and press Draw.</source>
        <translation>Выберите одно число или два и нажмите «Рисовать».</translation>
    </message>
    <message>
        <source>The scene has no number to vary.</source>
        <translation>В сцене нет числа, которое можно менять.</translation>
    </message>
    <message>
        <source>Stopped early: %1 of %2 pictures.</source>
        <translation>Остановлено раньше: изображений %1 из %2.</translation>
    </message>
    <message>
        <source>Click a picture to set its values in the text.</source>
        <translation>Щёлкните изображение, чтобы задать его значения в тексте.</translation>
    </message>
    <message>
        <source> values</source>
        <translation> знач.</translation>
    </message>
</context>
<context>
    <name>isoscope::ShortcutWindow</name>
    <message>
        <source>Keyboard and mouse</source>
        <translation>Клавиатура и мышь</translation>
    </message>
    <message>
        <source>Search commands and keys</source>
        <translation>Поиск команд и клавиш</translation>
    </message>
    <message>
        <source>Shows only lines that contain these words</source>
        <translation>Показывает только строки с этими словами</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Команда</translation>
    </message>
    <message>
        <source>Keys or mouse</source>
        <translation>Клавиши или мышь</translation>
    </message>
    <message>
        <source>Commands with their keys</source>
        <translation>Команды с их клавишами</translation>
    </message>
    <message>
        <source>Enter or a double click goes to the field for the command&apos;s keys</source>
        <translation>Enter или двойной щелчок ведёт к полю клавиш команды</translation>
    </message>
    <message>
        <source>Reset All</source>
        <translation>Сбросить все</translation>
    </message>
    <message>
        <source>Give every command the keys that the program comes with</source>
        <translation>Вернуть всем командам изначальные клавиши</translation>
    </message>
    <message>
        <source>New keys</source>
        <translation>Новые клавиши</translation>
    </message>
    <message>
        <source>Press the keys that shall call the command</source>
        <translation>Нажмите клавиши, которые будут вызывать команду</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Задать</translation>
    </message>
    <message>
        <source>Give the command these keys</source>
        <translation>Дать команде эти клавиши</translation>
    </message>
    <message>
        <source>No Keys</source>
        <translation>Без клавиш</translation>
    </message>
    <message>
        <source>Take the command&apos;s keys away</source>
        <translation>Забрать у команды клавиши</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Сбросить</translation>
    </message>
    <message>
        <source>Give the command the keys that it came with</source>
        <translation>Вернуть команде изначальные клавиши</translation>
    </message>
    <message>
        <source>What these keys would do</source>
        <translation>Что сделают эти клавиши</translation>
    </message>
    <message>
        <source>Keys of “%1”:</source>
        <translation>Клавиши «%1»:</translation>
    </message>
    <message>
        <source>Choose a command to change its keys.</source>
        <translation>Выберите команду, чтобы изменить её клавиши.</translation>
    </message>
    <message>
        <source>“%1” has these keys now and would lose them.</source>
        <translation>Эти клавиши сейчас у «%1», она их лишится.</translation>
    </message>
    <message>
        <source>These keys are free.</source>
        <translation>Эти клавиши свободны.</translation>
    </message>
</context>
<context>
    <name>isoscope::SliderNotePopup</name>
    <message>
        <source>Range, step and scale of %1</source>
        <translation>Диапазон, шаг и шкала %1</translation>
    </message>
    <message>
        <source>Enter sets the values, Esc leaves them as they are</source>
        <translation>Enter задаёт значения, Esc оставляет прежние</translation>
    </message>
    <message>
        <source>&amp;From</source>
        <translation>&amp;От</translation>
    </message>
    <message>
        <source>Lower end of the slider</source>
        <translation>Нижний край ползунка</translation>
    </message>
    <message>
        <source>&amp;To</source>
        <translation>&amp;До</translation>
    </message>
    <message>
        <source>Upper end of the slider</source>
        <translation>Верхний край ползунка</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>&amp;Шаг</translation>
    </message>
    <message>
        <source>How far apart values are; empty: as fine as the slider is</source>
        <translation>Расстояние между значениями; пусто: как позволяет ползунок</translation>
    </message>
    <message>
        <source>fine</source>
        <translation>мелкий</translation>
    </message>
    <message>
        <source>&amp;Decimals</source>
        <translation>&amp;Знаков</translation>
    </message>
    <message>
        <source>Digits behind the point that are written; empty: as many as needed</source>
        <translation>Сколько цифр писать после точки; пусто: сколько нужно</translation>
    </message>
    <message>
        <source>as needed</source>
        <translation>сколько нужно</translation>
    </message>
    <message>
        <source>&amp;Logarithmic</source>
        <translation>&amp;Логарифм</translation>
    </message>
    <message>
        <source>Equal ways multiply the number; the lower end must be above 0</source>
        <translation>Равные пути умножают число; нижний край должен быть больше 0</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Задать</translation>
    </message>
    <message>
        <source>Writes the values into the text, in a comment behind the number</source>
        <translation>Пишет значения в текст, в комментарий за числом</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 из %2</translation>
    </message>
    <message>
        <source>From and To must be numbers.</source>
        <translation>«От» и «До» должны быть числами.</translation>
    </message>
    <message>
        <source>From must be less than To.</source>
        <translation>«От» должно быть меньше «До».</translation>
    </message>
    <message>
        <source>A logarithmic slider must begin above 0.</source>
        <translation>Логарифмический ползунок должен начинаться выше 0.</translation>
    </message>
    <message>
        <source>The step must be above 0 and fit between From and To.</source>
        <translation>Шаг должен быть больше 0 и помещаться между «От» и «До».</translation>
    </message>
    <message>
        <source>Decimals must be a whole number from 0 to %1.</source>
        <translation>Знаков должно быть целое число от 0 до %1.</translation>
    </message>
</context>
<context>
    <name>isoscope::StartPage</name>
    <message>
        <source>Start page</source>
        <translation>Начальная страница</translation>
    </message>
    <message>
        <source>&lt;p&gt;Scenes to begin with. A click opens one; everything in it can be changed.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Сцены для начала. Щелчок открывает сцену; в ней можно изменить всё.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Begin with a picture</source>
        <translation>Начните с изображения</translation>
    </message>
    <message>
        <source>Choose one: its text opens at the left, and every number in it becomes a slider.</source>
        <translation>Выберите: текст откроется слева, и каждое число в нём станет ползунком.</translation>
    </message>
    <message>
        <source>Show this page at each start</source>
        <translation>Показывать эту страницу при каждом запуске</translation>
    </message>
    <message>
        <source>Otherwise File, Start Page opens it</source>
        <translation>Иначе её открывает «Файл, Начальная страница»</translation>
    </message>
    <message>
        <source>New Scene</source>
        <translation>Новая сцена</translation>
    </message>
    <message>
        <source>Begin with an empty scene</source>
        <translation>Начать с пустой сцены</translation>
    </message>
    <message>
        <source>Open File…</source>
        <translation>Открыть файл…</translation>
    </message>
    <message>
        <source>Open a scene or include file</source>
        <translation>Открыть сцену или включаемый файл</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Уроки</translation>
    </message>
    <message>
        <source>Read the short lessons about isosurfaces</source>
        <translation>Прочесть короткие уроки об изоповерхностях</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Закрыть</translation>
    </message>
    <message>
        <source>Go on with the scene that is open (Esc)</source>
        <translation>Продолжать с открытой сценой (Esc)</translation>
    </message>
</context>
<context>
    <name>isoscope::StudyController</name>
    <message>
        <source>There are no two isosurfaces to compare.</source>
        <translation>Нет двух изоповерхностей для сравнения.</translation>
    </message>
    <message>
        <source>The difference surface, f kept less f now, is on the clipboard.</source>
        <translation>Поверхность разности, отложенная f минус нынешняя f, в буфере обмена.</translation>
    </message>
</context>
<context>
    <name>isoscope::SurfaceChooser</name>
    <message>
        <source>Isosurface</source>
        <translation>Изоповерхность</translation>
    </message>
    <message>
        <source>Isosurface %1</source>
        <translation>Изоповерхность %1</translation>
    </message>
</context>
<context>
    <name>isoscope::SweepPanel</name>
    <message>
        <source>The number whose values are tried</source>
        <translation>Число, значения которого пробуются</translation>
    </message>
    <message>
        <source>Number that is varied</source>
        <translation>Меняемое число</translation>
    </message>
    <message>
        <source>from</source>
        <translation>от</translation>
    </message>
    <message>
        <source>First value</source>
        <translation>Первое значение</translation>
    </message>
    <message>
        <source>to</source>
        <translation>до</translation>
    </message>
    <message>
        <source>Last value</source>
        <translation>Последнее значение</translation>
    </message>
    <message>
        <source>Number of values</source>
        <translation>Число значений</translation>
    </message>
    <message>
        <source>How many values are tried</source>
        <translation>Сколько значений пробуется</translation>
    </message>
    <message>
        <source>Measure or stop</source>
        <translation>Измерить или остановить</translation>
    </message>
    <message>
        <source>Progress of the measurement</source>
        <translation>Ход измерения</translation>
    </message>
    <message>
        <source>How much of the measurement is done</source>
        <translation>Какая часть измерения сделана</translation>
    </message>
    <message>
        <source>About the measurement</source>
        <translation>Об измерении</translation>
    </message>
    <message>
        <source>sweep</source>
        <translation>перебор</translation>
    </message>
    <message>
        <source>Pieces, tunnels, hollows</source>
        <translation>Части, туннели, полости</translation>
    </message>
    <message>
        <source>Largest gradient</source>
        <translation>Наибольший градиент</translation>
    </message>
    <message>
        <source>What the right chart shows</source>
        <translation>Что показывает правый график</translation>
    </message>
    <message>
        <source>Evaluations per pixel</source>
        <translation>Вычислений на пиксель</translation>
    </message>
    <message>
        <source>Click to write a value into the text</source>
        <translation>Щелчок записывает значение в текст</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Стоп</translation>
    </message>
    <message>
        <source>Measure Again</source>
        <translation>Измерить снова</translation>
    </message>
    <message>
        <source>End the measurement; what is measured stays</source>
        <translation>Закончить измерение; измеренное остаётся</translation>
    </message>
    <message>
        <source>Try the values of the number in small pictures</source>
        <translation>Попробовать значения числа на малых изображениях</translation>
    </message>
    <message>
        <source>It is measured as soon as nothing moves.</source>
        <translation>Измеряется, как только ничто не движется.</translation>
    </message>
    <message>
        <source>The scene has no isosurface with a number to vary.</source>
        <translation>В сцене нет изоповерхности с меняемым числом.</translation>
    </message>
    <message>
        <source>POV-Ray</source>
        <translation>POV-Ray</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>точно</translation>
    </message>
    <message>
        <source>attained</source>
        <translation>достигнуто</translation>
    </message>
    <message>
        <source>proven</source>
        <translation>доказано</translation>
    </message>
    <message>
        <source>pieces</source>
        <translation>части</translation>
    </message>
    <message>
        <source>tunnels</source>
        <translation>туннели</translation>
    </message>
    <message>
        <source>hollows</source>
        <translation>полости</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>сейчас %1</translation>
    </message>
    <message>
        <source>Chart of %1 over %2</source>
        <translation>График %1 по %2</translation>
    </message>
    <message>
        <source>Measured before the last change of scene or view.</source>
        <translation>Измерено до последнего изменения сцены или вида.</translation>
    </message>
    <message>
        <source>Stopped early.</source>
        <translation>Остановлено раньше.</translation>
    </message>
    <message>
        <source>Evaluations of the camera&apos;s rays; pieces of a grid of %1 cells.</source>
        <translation>Вычисления лучей камеры; части по сетке из %1 ячеек.</translation>
    </message>
    <message>
        <source>The scene cannot be read for %1 of the values.</source>
        <translation>При %1 из значений сцену нельзя прочитать.</translation>
    </message>
    <message>
        <source> values</source>
        <translation> знач.</translation>
    </message>
</context>
<context>
    <name>isoscope::ThresholdPanel</name>
    <message>
        <source>proven</source>
        <translation>доказано</translation>
    </message>
    <message>
        <source>suspected: the search ended before</source>
        <translation>подозрение: поиск закончен раньше</translation>
    </message>
    <message>
        <source>suspected: at the container&apos;s wall</source>
        <translation>подозрение: у стенки контейнера</translation>
    </message>
    <message>
        <source>suspected: the function is constant there</source>
        <translation>подозрение: функция там постоянна</translation>
    </message>
    <message>
        <source>suspected: more than a point</source>
        <translation>подозрение: больше точки</translation>
    </message>
    <message>
        <source>suspected: a kink</source>
        <translation>подозрение: излом</translation>
    </message>
    <message>
        <source>suspected: no bound of the gradient</source>
        <translation>подозрение: нет границы градиента</translation>
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
        <translation>Изоповерхность, порог которой рассматривается.</translation>
    </message>
    <message>
        <source>Histogram of the function</source>
        <translation>Гистограмма функции</translation>
    </message>
    <message>
        <source>How much of the container has which value of the function. Drag to move the threshold; it sticks to the lines, at which the surface changes its form.</source>
        <translation>Какая часть контейнера имеет какое значение функции. Тяните, чтобы сдвинуть порог; он липнет к линиям, на которых поверхность меняет форму.</translation>
    </message>
    <message>
        <source>About the threshold</source>
        <translation>О пороге</translation>
    </message>
    <message>
        <source>Progress of the search</source>
        <translation>Ход поиска</translation>
    </message>
    <message>
        <source>How much of the search for critical values is done</source>
        <translation>Какая часть поиска критических значений сделана</translation>
    </message>
    <message>
        <source>Search or stop</source>
        <translation>Искать или остановить</translation>
    </message>
    <message>
        <source>threshold</source>
        <translation>порог</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Порог</translation>
    </message>
    <message>
        <source>What happens as it rises</source>
        <translation>Что бывает при росте</translation>
    </message>
    <message>
        <source>Certainty</source>
        <translation>Надёжность</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Где</translation>
    </message>
    <message>
        <source>Thresholds at which the surface changes its form</source>
        <translation>Пороги, при которых поверхность меняет форму</translation>
    </message>
    <message>
        <source>A double click, or Enter, sets the threshold</source>
        <translation>Двойной щелчок или Enter задаёт порог</translation>
    </message>
    <message>
        <source>two pieces join or a tunnel opens (×88)</source>
        <translation>две части сливаются или туннель (×88)</translation>
    </message>
    <message>
        <source>suspected: a kink_</source>
        <translation>подозрение: излом_</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Взять</translation>
    </message>
    <message>
        <source>Go There</source>
        <translation>Туда</translation>
    </message>
    <message>
        <source>Writes this threshold into the text.</source>
        <translation>Пишет этот порог в текст.</translation>
    </message>
    <message>
        <source>Use the chosen threshold</source>
        <translation>Взять выбранный порог</translation>
    </message>
    <message>
        <source>Shows the place where it happens in the picture.</source>
        <translation>Показывает на изображении, где это происходит.</translation>
    </message>
    <message>
        <source>Show the place of the chosen threshold</source>
        <translation>Показать место выбранного порога</translation>
    </message>
    <message>
        <source>The values of the function are shown here once nothing moves.</source>
        <translation>Значения функции появятся здесь, когда ничто не движется.</translation>
    </message>
    <message>
        <source>The scene has no isosurface.</source>
        <translation>В сцене нет изоповерхности.</translation>
    </message>
    <message>
        <source>Distribution of the function</source>
        <translation>Распределение функции</translation>
    </message>
    <message>
        <source>in the container</source>
        <translation>в контейнере</translation>
    </message>
    <message>
        <source>pieces or hollows appear, go</source>
        <translation>части или полости появляются, исчезают</translation>
    </message>
    <message>
        <source>pieces join, tunnels</source>
        <translation>части сливаются, туннели</translation>
    </message>
    <message>
        <source>suspected</source>
        <translation>подозрение</translation>
    </message>
    <message>
        <source>threshold %1</source>
        <translation>порог %1</translation>
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
        <translation>Что бывает при убывании</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Стоп</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Искать</translation>
    </message>
    <message>
        <source>End the search for critical values</source>
        <translation>Закончить поиск критических значений</translation>
    </message>
    <message>
        <source>Search for the values at which the surface changes its form</source>
        <translation>Искать значения, при которых поверхность меняет форму</translation>
    </message>
    <message>
        <source>%1 of the container is inside.</source>
        <translation>Внутри %1 контейнера.</translation>
    </message>
    <message>
        <source>Values at which its form changes: %1 proven, %2 suspected, no others but at the container&apos;s wall.</source>
        <translation>Значения, при которых меняется форма: доказано %1, подозрений %2, других нет, кроме как у стенки контейнера.</translation>
    </message>
    <message>
        <source>The first %1 are listed.</source>
        <translation>Перечислены первые %1.</translation>
    </message>
    <message>
        <source>Where the function jumps there may be more.</source>
        <translation>Где функция скачет, их может быть больше.</translation>
    </message>
</context>
<context>
    <name>isoscope::TimelineController</name>
    <message>
        <source>Nothing differs from its keys at this frame.</source>
        <translation>На этом кадре ничто не отличается от ключей.</translation>
    </message>
</context>
<context>
    <name>isoscope::TimelinePanel</name>
    <message>
        <source>Timeline</source>
        <translation>Шкала времени</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>Первый кадр</translation>
    </message>
    <message>
        <source>Go to the first frame</source>
        <translation>К первому кадру</translation>
    </message>
    <message>
        <source>Play the animation</source>
        <translation>Пустить анимацию</translation>
    </message>
    <message>
        <source>Play the frames in their time; Esc stops</source>
        <translation>Показывать кадры в их темпе; Esc останавливает</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Последний кадр</translation>
    </message>
    <message>
        <source>Go to the last frame</source>
        <translation>К последнему кадру</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Повтор</translation>
    </message>
    <message>
        <source>Begin anew at the last frame</source>
        <translation>На последнем кадре начинать сначала</translation>
    </message>
    <message>
        <source>F&amp;rame</source>
        <translation>&amp;Кадр</translation>
    </message>
    <message>
        <source>Present frame</source>
        <translation>Нынешний кадр</translation>
    </message>
    <message>
        <source>The frame that is shown</source>
        <translation>Показанный кадр</translation>
    </message>
    <message>
        <source>Set Key</source>
        <translation>Поставить ключ</translation>
    </message>
    <message>
        <source>Keep the present value of a number, or the view, at this frame; in the text</source>
        <translation>Сохранить нынешнее значение числа или вид на этом кадре; в тексте</translation>
    </message>
    <message>
        <source>Remove key</source>
        <translation>Убрать ключ</translation>
    </message>
    <message>
        <source>Take the key of the chosen row at this frame away (Delete)</source>
        <translation>Убрать ключ выбранного ряда на этом кадре (Delete)</translation>
    </message>
    <message>
        <source>Way to the next key</source>
        <translation>Путь к следующему ключу</translation>
    </message>
    <message>
        <source>How the value goes from the key of the chosen row at this frame to its next one</source>
        <translation>Как значение идёт от ключа выбранного ряда на этом кадре к следующему</translation>
    </message>
    <message>
        <source>Fra&amp;mes</source>
        <translation>Ка&amp;дры</translation>
    </message>
    <message>
        <source>First frame of the animation</source>
        <translation>Первый кадр анимации</translation>
    </message>
    <message>
        <source>Number of the first frame</source>
        <translation>Номер первого кадра</translation>
    </message>
    <message>
        <source>to</source>
        <translation>до</translation>
    </message>
    <message>
        <source>Last frame of the animation</source>
        <translation>Последний кадр анимации</translation>
    </message>
    <message>
        <source>Number of the last frame</source>
        <translation>Номер последнего кадра</translation>
    </message>
    <message>
        <source>Frames per second</source>
        <translation>Кадров в секунду</translation>
    </message>
    <message>
        <source>How fast the animation plays</source>
        <translation>Как быстро идёт анимация</translation>
    </message>
    <message>
        <source>per second</source>
        <translation>в секунду</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Экспорт</translation>
    </message>
    <message>
        <source>Draw all frames into pictures, and a film where ffmpeg is installed</source>
        <translation>Нарисовать все кадры в картинки, и фильм, если установлен ffmpeg</translation>
    </message>
    <message>
        <source>cl&amp;ock</source>
        <translation>cl&amp;ock</translation>
    </message>
    <message>
        <source>Clock of the first frame</source>
        <translation>Clock первого кадра</translation>
    </message>
    <message>
        <source>The value of clock in the first frame, for the text and for POV-Ray</source>
        <translation>Значение clock на первом кадре, для текста и для POV-Ray</translation>
    </message>
    <message>
        <source>Clock of the last frame</source>
        <translation>Clock последнего кадра</translation>
    </message>
    <message>
        <source>The value of clock in the last frame, for the text and for POV-Ray</source>
        <translation>Значение clock на последнем кадре, для текста и для POV-Ray</translation>
    </message>
    <message>
        <source>Stop the animation</source>
        <translation>Остановить анимацию</translation>
    </message>
    <message>
        <source>What differs from its keys</source>
        <translation>Отличное от ключей</translation>
    </message>
    <message>
        <source>A key for each number with keys, and for the view, that differs from them now</source>
        <translation>Ключ каждому числу с ключами и виду, если они сейчас отличаются от них</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Вид</translation>
    </message>
    <message>
        <source>A key for the camera: the present view</source>
        <translation>Ключ для камеры: нынешний вид</translation>
    </message>
    <message>
        <source>A key for this number: its present value</source>
        <translation>Ключ для этого числа: нынешнее значение</translation>
    </message>
</context>
<context>
    <name>isoscope::TimelineView</name>
    <message>
        <source>Frames and keys</source>
        <translation>Кадры и ключи</translation>
    </message>
    <message>
        <source>Drag to go to a frame, drag a key to move it; a right click on a key has more</source>
        <translation>Тяните, чтобы перейти к кадру; тяните ключ, чтобы сдвинуть его; правый щелчок по ключу — ещё</translation>
    </message>
    <message>
        <source>Frame %1 of %2 to %3</source>
        <translation>Кадр %1 от %2 до %3</translation>
    </message>
    <message>
        <source>%1 has no key here</source>
        <translation>У %1 здесь нет ключа</translation>
    </message>
    <message>
        <source>%1 (not in the text)</source>
        <translation>%1 (нет в тексте)</translation>
    </message>
    <message>
        <source>No keys yet: go to a frame, move a slider or the view, and choose Set Key.</source>
        <translation>Ключей ещё нет: перейдите к кадру, сдвиньте ползунок или вид и нажмите «Поставить ключ».</translation>
    </message>
</context>
<context>
    <name>isoscope::VerdictBadge</name>
    <message>
        <source>isosurface in line %1</source>
        <translation>изоповерхность в строке %1</translation>
    </message>
    <message>
        <source>isosurface %1</source>
        <translation>изоповерхность %1</translation>
    </message>
    <message>
        <source>no holes: proven</source>
        <translation>без дыр: доказано</translation>
    </message>
    <message>
        <source>holes: %1</source>
        <translation>дыры: %1</translation>
    </message>
    <message>
        <source>%1 × slower than need be</source>
        <translation>в %1 раз медленнее, чем нужно</translation>
    </message>
    <message>
        <source>&lt;p&gt;Whether POV-Ray&apos;s picture of the isosurfaces of this text has holes, or takes longer than it has to. This is proven in the background, for every isosurface; the badge tells the worst.&lt;/p&gt;&lt;p&gt;POV-Ray&apos;s root finder trusts &lt;b&gt;max_gradient&lt;/b&gt;: where the function is steeper, it steps over the surface. Click to see the numbers in the panel “Gradient”.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Есть ли в изображении POV-Ray дыры у изоповерхностей этого текста и не тратит ли он больше времени, чем нужно. Доказывается в фоне для каждой изоповерхности; значок говорит о худшей.&lt;/p&gt;&lt;p&gt;Поиск корней POV-Ray верит &lt;b&gt;max_gradient&lt;/b&gt;: где функция круче, он перешагивает поверхность. Щёлкните, чтобы увидеть числа на панели «Градиент».&lt;/p&gt;</translation>
    </message>
    <message>
        <source> (%1 of %2)</source>
        <translation> (%1 из %2)</translation>
    </message>
    <message>
        <source>&lt;p&gt;%1 more.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Ещё %1.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Verdict on max_gradient: %1</source>
        <translation>Заключение о max_gradient: %1</translation>
    </message>
    <message>
        <source>Use %1: %2</source>
        <translation>Взять %1: %2</translation>
    </message>
    <message>
        <source>Fix All %1</source>
        <translation>Исправить все %1</translation>
    </message>
    <message>
        <source>Still reading…</source>
        <translation>Ещё читается…</translation>
    </message>
    <message>
        <source>The text is still being read; its isosurfaces are judged afterwards.</source>
        <translation>Текст ещё читается; его изоповерхности оцениваются потом.</translation>
    </message>
    <message>
        <source>Verdict on max_gradient: the text is still being read</source>
        <translation>Заключение о max_gradient: текст ещё читается</translation>
    </message>
</context>
<context>
    <name>isoscope::VerdictController</name>
    <message>
        <source>infinitely steep</source>
        <translation>бесконечно крута</translation>
    </message>
    <message>
        <source>steepest: %1</source>
        <translation>круче всего: %1</translation>
    </message>
    <message>
        <source>No problems. Everything in the text is shown.</source>
        <translation>Проблем нет. Показано всё, что есть в тексте.</translation>
    </message>
    <message>
        <source>The text is still being read.</source>
        <translation>Текст ещё читается.</translation>
    </message>
    <message>
        <source>The text has no mistakes.</source>
        <translation>В тексте нет ошибок.</translation>
    </message>
    <message>
        <source>No problems so far. Whether POV-Ray&apos;s picture has holes is being found out.</source>
        <translation>Пока проблем нет. Выясняется, есть ли дыры в изображении POV-Ray.</translation>
    </message>
    <message>
        <source>POV-Ray&apos;s picture has no holes: that is proven.</source>
        <translation>В изображении POV-Ray нет дыр: это доказано.</translation>
    </message>
</context>
<context>
    <name>isoscope::ViewController</name>
    <message>
        <source>There is nothing to fit: what the scene shows is empty, or has no end.</source>
        <translation>Показывать нечего: сцена пуста или не имеет конца.</translation>
    </message>
</context>
<context>
    <name>isoscope::ViewOverlay</name>
    <message>
        <source>The pictures cannot be compared.</source>
        <translation>Изображения нельзя сравнить.</translation>
    </message>
    <message>
        <source>There is no text that POV-Ray could draw.</source>
        <translation>Нет текста, который мог бы нарисовать POV-Ray.</translation>
    </message>
    <message>
        <source>POV-Ray draws the picture…</source>
        <translation>POV-Ray рисует изображение…</translation>
    </message>
    <message>
        <source>Measuring the gradient on the surface…</source>
        <translation>Измеряется градиент на поверхности…</translation>
    </message>
    <message>
        <source>Comparing POV-Ray&apos;s picture with the exact one…</source>
        <translation>Изображение POV-Ray сравнивается с точным…</translation>
    </message>
    <message>
        <source>Stopped. Redraw the picture to see it.</source>
        <translation>Остановлено. Перерисуйте изображение, чтобы увидеть.</translation>
    </message>
    <message>
        <source>Waits for the picture.</source>
        <translation>Ждёт изображения.</translation>
    </message>
    <message>
        <source>Nothing is kept. Choose Compare again to keep the scene as it is.</source>
        <translation>Ничего не отложено. Выберите «Сравнить» снова, чтобы отложить сцену как есть.</translation>
    </message>
    <message>
        <source>Drawing the kept scene…</source>
        <translation>Рисуется отложенная сцена…</translation>
    </message>
    <message>
        <source>Left of the divider the kept scene, right of it the present one</source>
        <translation>Слева от границы отложенная сцена, справа нынешняя</translation>
    </message>
    <message>
        <source>POV-Ray itself</source>
        <translation>сам POV-Ray</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>точно</translation>
    </message>
    <message>
        <source>A, kept</source>
        <translation>A, отложено</translation>
    </message>
    <message>
        <source>B, now</source>
        <translation>B, сейчас</translation>
    </message>
    <message>
        <source>as POV-Ray</source>
        <translation>как POV-Ray</translation>
    </message>
    <message>
        <source>Counting what each pixel takes…</source>
        <translation>Подсчёт вычислений для каждого пикселя…</translation>
    </message>
</context>
<context>
    <name>isoscope::Viewport</name>
    <message>
        <source>Picture of the scene</source>
        <translation>Изображение сцены</translation>
    </message>
    <message>
        <source>Arrow keys turn the view, Shift and arrow keys shift it, plus and minus zoom, Home resets; Alt and arrow keys move the divider of a split view</source>
        <translation>Стрелки поворачивают вид, Shift и стрелки сдвигают, плюс и минус меняют масштаб, Home сбрасывает; Alt и стрелки двигают границу разделённого вида</translation>
    </message>
    <message>
        <source>Drag to turn, right-drag or Shift-drag to shift, wheel to zoom, double-click to reset, Ctrl-drag to take the picture elsewhere</source>
        <translation>Тянуть — поворот, правой кнопкой или с Shift — сдвиг, колесо — масштаб, двойной щелчок — сброс, с Ctrl — унести изображение</translation>
    </message>
    <message>
        <source>Nothing to see yet: the text has no object.
Type a formula, such as x*x + y*y + z*z - 1, or insert a function, to begin.</source>
        <translation>Смотреть пока не на что: в тексте нет объекта.
Введите формулу, например x*x + y*y + z*z - 1, или вставьте функцию.</translation>
    </message>
</context>
<context>
    <name>isoscope::ViewportPanel</name>
    <message>
        <source>View tools</source>
        <translation>Инструменты вида</translation>
    </message>
    <message>
        <source>More tools</source>
        <translation>Ещё инструменты</translation>
    </message>
    <message>
        <source>State of the picture</source>
        <translation>Состояние изображения</translation>
    </message>
    <message>
        <source>How far the picture is, and the time since it began.</source>
        <translation>Как далеко изображение и сколько времени прошло с начала.</translation>
    </message>
    <message>
        <source>Cost of the picture</source>
        <translation>Стоимость изображения</translation>
    </message>
    <message>
        <source>How much of the picture is proven to be right, and what it cost. Exact pictures are proven pixel by pixel, by the certified root finder; the cost is told in rays and in evaluations of functions.</source>
        <translation>Какая часть изображения доказана и сколько это стоило. Точные изображения доказываются пиксель за пикселем сертифицированным поиском корней; стоимость — в лучах и вычислениях функций.</translation>
    </message>
    <message>
        <source>No picture yet</source>
        <translation>Изображения ещё нет</translation>
    </message>
    <message>
        <source>Pass %1 of %2, %3 s</source>
        <translation>Проход %1 из %2, %3 с</translation>
    </message>
    <message>
        <source>Stopped after pass %1 of %2, %3 s</source>
        <translation>Остановлено после прохода %1 из %2, %3 с</translation>
    </message>
    <message>
        <source>Finished in %1 s, %2 × %3</source>
        <translation>Готово за %1 с, %2 × %3</translation>
    </message>
    <message>
        <source>%1 rays, %2 evaluations</source>
        <translation>Лучей: %1, вычислений: %2</translation>
    </message>
    <message>
        <source>Nothing was there to prove</source>
        <translation>Доказывать было нечего</translation>
    </message>
</context>
<context>
    <name>isoscope::VtkPanel</name>
    <message>
        <source>This panel cannot be drawn: %1.</source>
        <translation>Эту панель нельзя нарисовать: %1.</translation>
    </message>
</context>
<context>
    <name>isoscope::WhatsThis</name>
    <message>
        <source>&lt;p&gt;The level at which the surface lies: it is where the function has this value, and the solid is where the function is smaller.&lt;/p&gt;&lt;p&gt;&lt;b&gt;threshold&lt;/b&gt; is 0 where the text says nothing.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Уровень, на котором лежит поверхность: она там, где функция имеет это значение, а тело там, где функция меньше.&lt;/p&gt;&lt;p&gt;&lt;b&gt;threshold&lt;/b&gt; равен 0, если текст молчит.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;How closely the place of the surface is found. Smaller is finer and takes longer; sheets thinner than this may be missed.&lt;/p&gt;&lt;p&gt;POV-Ray ends its search along a ray when the interval is shorter than &lt;b&gt;accuracy&lt;/b&gt;.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Насколько точно находится место поверхности. Меньше — тоньше и дольше; более тонкие листы могут быть пропущены.&lt;/p&gt;&lt;p&gt;POV-Ray кончает поиск вдоль луча, когда интервал короче &lt;b&gt;accuracy&lt;/b&gt;.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;How steep POV-Ray takes the function to be. Too low leaves holes in its picture, too high makes it slow; the badge in the status line tells which, with proof.&lt;/p&gt;&lt;p&gt;The gradient of the function must nowhere in the container be longer than &lt;b&gt;max_gradient&lt;/b&gt;.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Насколько крутой POV-Ray считает функцию. Слишком мало — дыры в изображении, слишком много — медленно; значок в строке состояния говорит что, с доказательством.&lt;/p&gt;&lt;p&gt;Градиент функции нигде в контейнере не должен быть длиннее &lt;b&gt;max_gradient&lt;/b&gt;.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Shows the surface as it is, without holes.&lt;/p&gt;&lt;p&gt;The certified root finder encloses the function along every ray and proves what it finds; it needs no max_gradient. Pixels that could not be proven are counted below the picture.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Показывает поверхность как есть, без дыр.&lt;/p&gt;&lt;p&gt;Сертифицированный поиск корней заключает функцию в границы вдоль каждого луча и доказывает найденное; max_gradient ему не нужен. Недоказанные пиксели посчитаны под изображением.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Shows what POV-Ray will draw, holes included.&lt;/p&gt;&lt;p&gt;POV-Ray&apos;s root finder trusts max_gradient and accuracy of the text; where the function is steeper than max_gradient it may step over the surface.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Показывает, что нарисует POV-Ray, вместе с дырами.&lt;/p&gt;&lt;p&gt;Поиск корней POV-Ray верит max_gradient и accuracy текста; где функция круче max_gradient, он может перешагнуть поверхность.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Marks the pixels that are not proven to be right; mostly there are none.&lt;/p&gt;&lt;p&gt;The certified root finder leaves a pixel unproven when a root closer than accuracy/100 may hide there, when the ray took too many evaluations, or when the function has no known bounds.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Отмечает пиксели, верность которых не доказана; чаще всего таких нет.&lt;/p&gt;&lt;p&gt;Сертифицированный поиск корней оставляет пиксель недоказанным, если там может скрываться корень ближе accuracy/100, если луч стоил слишком много вычислений или если границы функции неизвестны.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Shows where POV-Ray&apos;s picture would have holes, over the exact picture.&lt;/p&gt;&lt;p&gt;Both root finders are run; pixels are lost, gained, or found at a wrong place.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Показывает поверх точного изображения, где в изображении POV-Ray были бы дыры.&lt;/p&gt;&lt;p&gt;Работают оба поиска корней; пиксели потеряны, лишние или не на месте.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Shows both pictures side by side: POV-Ray&apos;s at the left, the exact one at the right. Drag the divider.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Показывает оба изображения рядом: POV-Ray слева, точное справа. Тяните границу.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Shows only what POV-Ray&apos;s picture gets wrong, without the picture itself.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Показывает только неверное в изображении POV-Ray, без самого изображения.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Colours the surface by how steep the function is there; red is too steep for POV-Ray.&lt;/p&gt;&lt;p&gt;The colour is the length of the gradient as a share of max_gradient.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Раскрашивает поверхность по крутизне функции; красное слишком круто для POV-Ray.&lt;/p&gt;&lt;p&gt;Цвет — длина градиента в долях max_gradient.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Has the POV-Ray that is installed draw the text, in a folder of its own, and shows its picture left of a divider that can be dragged, the exact one right of it. It is drawn anew for every view that rests.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Установленный POV-Ray рисует текст в собственной папке; его изображение слева от границы, которую можно тянуть, точное справа. Рисуется заново для каждого вида в покое.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Has the POV-Ray that is installed draw the text and marks each pixel that differs from the exact picture by its cause: holes, accuracy, jumps, outlines, and what is not shown here.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Установленный POV-Ray рисует текст; каждый пиксель, отличный от точного изображения, отмечен по причине: дыры, accuracy, скачки, контуры и то, что здесь не показано.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Shows what you change beside what was.&lt;/p&gt;&lt;p&gt;The scene is kept as it is at this moment (A); from now on it is drawn left of the divider, and the present one (B) right of it: other values, or another function. Choose it again to keep the present scene instead.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Показывает изменённое рядом с тем, что было.&lt;/p&gt;&lt;p&gt;Сцена откладывается какой есть (A); отныне она слева от границы, а нынешняя (B) справа: другие значения или другая функция. Выберите снова, чтобы отложить нынешнюю сцену.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Shows the picture alone, with nothing laid over it.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Показывает только изображение, без наложений.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Click a pixel to see why it looks as it does: how the function runs along the line of sight, where the surface is met, and what POV-Ray stepped over.&lt;/p&gt;&lt;p&gt;The panel “Ray” charts the function over the distance along the &lt;b&gt;ray&lt;/b&gt;.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Щёлкните пиксель, чтобы узнать, почему он таков: как идёт функция вдоль линии взгляда, где встречается поверхность и что перешагнул POV-Ray.&lt;/p&gt;&lt;p&gt;Панель «Луч» строит график функции по расстоянию вдоль &lt;b&gt;луча&lt;/b&gt;.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Shows where the object is cut, and lets you drag the cut.&lt;/p&gt;&lt;p&gt;The &lt;b&gt;cross-section&lt;/b&gt; shows the values of the function on that plane.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Показывает, где разрезан объект, и позволяет тянуть разрез.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Сечение&lt;/b&gt; показывает значения функции на этой плоскости.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Shows what each pixel takes in evaluations of the function, the brighter the more, in the colour of the cause: empty space in the container, a field that is steep elsewhere, rays along the surface, places where the function jumps.&lt;/p&gt;&lt;p&gt;It counts for the root finder of the picture, exact or as POV-Ray.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Показывает, сколько вычислений функции требует каждый пиксель: чем больше, тем ярче, цветом причины: пустота в контейнере, поле, крутое в других местах, лучи вдоль поверхности, места, где функция скачет.&lt;/p&gt;&lt;p&gt;Считается для поиска корней изображения: точного или как POV-Ray.&lt;/p&gt;</translation>
    </message>
</context>
</TS>
