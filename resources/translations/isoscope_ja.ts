<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja" sourcelanguage="en">
<context>
    <name>CostOverlay</name>
    <message>
        <source>empty space: a smaller container would save it (%1, %2)</source>
        <translation>空き空間: コンテナを小さくすれば省ける (%1, %2)</translation>
    </message>
    <message>
        <source>finding the surface (%1, %2)</source>
        <translation>曲面を見つけるまで (%1, %2)</translation>
    </message>
    <message>
        <source>steep field: f is flatter here than it may be elsewhere (%1, %2)</source>
        <translation>急な場: f はここではほかの場所より緩やか (%1, %2)</translation>
    </message>
    <message>
        <source>grazing rays: along the surface (%1, %2)</source>
        <translation>かすめるレイ: 曲面に沿う (%1, %2)</translation>
    </message>
    <message>
        <source>singularity: f jumps, is undefined or infinitely steep (%1, %2)</source>
        <translation>特異点: f が跳ぶ、未定義、または無限に急 (%1, %2)</translation>
    </message>
    <message>
        <source>No function is evaluated in this view</source>
        <translation>このビューで評価される関数はありません</translation>
    </message>
    <message>
        <source>Evaluations of f by the rays of the camera: %1 for a pixel, at most %2</source>
        <translation>カメラのレイによる f の評価: 1 ピクセルあたり %1、最大 %2</translation>
    </message>
</context>
<context>
    <name>EditorKeys</name>
    <message>
        <source>To the character before</source>
        <translation>前の文字へ</translation>
    </message>
    <message>
        <source>To the next character</source>
        <translation>次の文字へ</translation>
    </message>
    <message>
        <source>To the line above</source>
        <translation>上の行へ</translation>
    </message>
    <message>
        <source>To the line below</source>
        <translation>下の行へ</translation>
    </message>
    <message>
        <source>To the word before</source>
        <translation>前の単語へ</translation>
    </message>
    <message>
        <source>To the next word</source>
        <translation>次の単語へ</translation>
    </message>
    <message>
        <source>To the beginning of the line</source>
        <translation>行の先頭へ</translation>
    </message>
    <message>
        <source>To the end of the line</source>
        <translation>行の末尾へ</translation>
    </message>
    <message>
        <source>A page up</source>
        <translation>1 ページ上へ</translation>
    </message>
    <message>
        <source>A page down</source>
        <translation>1 ページ下へ</translation>
    </message>
    <message>
        <source>To the beginning of the text</source>
        <translation>テキストの先頭へ</translation>
    </message>
    <message>
        <source>To the end of the text</source>
        <translation>テキストの末尾へ</translation>
    </message>
    <message>
        <source>Close the list of words or the help on a function</source>
        <translation>単語の一覧または関数の説明を閉じる</translation>
    </message>
    <message>
        <source>New line</source>
        <translation>改行</translation>
    </message>
    <message>
        <source>Indent, or take a word from the list</source>
        <translation>字下げ、または一覧の単語を採用</translation>
    </message>
    <message>
        <source>Take indentation away</source>
        <translation>字下げを戻す</translation>
    </message>
    <message>
        <source>Delete the character before</source>
        <translation>前の文字を削除</translation>
    </message>
    <message>
        <source>Delete the next character</source>
        <translation>次の文字を削除</translation>
    </message>
    <message>
        <source>Delete to the beginning of the word</source>
        <translation>単語の先頭まで削除</translation>
    </message>
    <message>
        <source>Delete to the end of the word</source>
        <translation>単語の末尾まで削除</translation>
    </message>
    <message>
        <source>Number at the caret: one step up</source>
        <translation>カーソル位置の数値: 1 ステップ増やす</translation>
    </message>
    <message>
        <source>Number at the caret: one step down</source>
        <translation>カーソル位置の数値: 1 ステップ減らす</translation>
    </message>
    <message>
        <source>Number at the caret: a tenth of a step up</source>
        <translation>カーソル位置の数値: 0.1 ステップ増やす</translation>
    </message>
    <message>
        <source>Number at the caret: a tenth of a step down</source>
        <translation>カーソル位置の数値: 0.1 ステップ減らす</translation>
    </message>
    <message>
        <source>Number at the caret: ten steps up</source>
        <translation>カーソル位置の数値: 10 ステップ増やす</translation>
    </message>
    <message>
        <source>Number at the caret: ten steps down</source>
        <translation>カーソル位置の数値: 10 ステップ減らす</translation>
    </message>
</context>
<context>
    <name>Gallery</name>
    <message>
        <source>POV-Ray&apos;s snippet: %1</source>
        <translation>POV-Ray のスニペット: %1</translation>
    </message>
</context>
<context>
    <name>HeatOverlay</name>
    <message>
        <source>No isosurface is seen in this view</source>
        <translation>このビューに等値面は見えません</translation>
    </message>
    <message>
        <source>Gradient here: at most %1 of max_gradient</source>
        <translation>ここの勾配: 最大で max_gradient の %1</translation>
    </message>
    <message>
        <source>Gradient here: up to %1 times max_gradient, over it in %2 of %3 pixels</source>
        <translation>ここの勾配: 最大で max_gradient の %1 倍、%3 ピクセル中 %2 で超過</translation>
    </message>
    <message>
        <source>|∇f| ÷ max_gradient</source>
        <translation>|∇f| ÷ max_gradient</translation>
    </message>
    <message>
        <source>over %1</source>
        <translation>%1 超</translation>
    </message>
</context>
<context>
    <name>HelpPanel</name>
    <message>
        <source>It has no parameters but the place.</source>
        <translation>位置のほかにパラメータはありません。</translation>
    </message>
    <message>
        <source>| formula | parameter | usual value | range |</source>
        <translation>| 式 | パラメータ | 通常の値 | 範囲 |</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1～%2</translation>
    </message>
    <message>
        <source>Formula</source>
        <translation>式</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>パラメータ</translation>
    </message>
    <message>
        <source>In a scene</source>
        <translation>シーンでの使い方</translation>
    </message>
    <message>
        <source>All built-in functions</source>
        <translation>すべての組み込み関数</translation>
    </message>
    <message>
        <source>Numbered functions</source>
        <translation>番号付き関数</translation>
    </message>
    <message>
        <source>Patterns as functions</source>
        <translation>関数としてのパターン</translation>
    </message>
    <message>
        <source>Built-in functions</source>
        <translation>組み込み関数</translation>
    </message>
</context>
<context>
    <name>HoleOverlay</name>
    <message>
        <source>POV-Ray&apos;s method loses none of %1 pixels</source>
        <translation>POV-Ray の方法は %1 ピクセルを 1 つも失いません</translation>
    </message>
    <message>
        <source>POV-Ray&apos;s method: %1 lost, %2 gained, %3 at a wrong place</source>
        <translation>POV-Ray の方法: 消失 %1、余分 %2、位置違い %3</translation>
    </message>
    <message>
        <source>lost: a hole in POV-Ray&apos;s picture (%1)</source>
        <translation>消失: POV-Ray の画像の穴 (%1)</translation>
    </message>
    <message>
        <source>gained: POV-Ray hits where nothing is (%1)</source>
        <translation>余分: 何もない所で POV-Ray が当たる (%1)</translation>
    </message>
    <message>
        <source>wrong place: another sheet, or off by more than accuracy explains (%1)</source>
        <translation>位置違い: 別の面、または accuracy で説明できないずれ (%1)</translation>
    </message>
</context>
<context>
    <name>PictureQueueWindow</name>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 分</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 時間</translation>
    </message>
    <message>
        <source>Waits</source>
        <translation>待機中</translation>
    </message>
    <message>
        <source>Is rendered…</source>
        <translation>計算中…</translation>
    </message>
    <message>
        <source>About %1 left</source>
        <translation>残り約 %1</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>書き込み済み</translation>
    </message>
    <message>
        <source>Stopped; nothing was written</source>
        <translation>停止しました。何も書き込んでいません</translation>
    </message>
</context>
<context>
    <name>PovrayOverlay</name>
    <message>
        <source>hole: max_gradient is too low (%1)</source>
        <translation>穴: max_gradient が小さすぎる (%1)</translation>
    </message>
    <message>
        <source>POV-Ray hits where nothing is (%1)</source>
        <translation>何もない所で POV-Ray が当たる (%1)</translation>
    </message>
    <message>
        <source>another sheet: max_gradient is too low (%1)</source>
        <translation>別の面: max_gradient が小さすぎる (%1)</translation>
    </message>
    <message>
        <source>other shades, by accuracy (%1)</source>
        <translation>accuracy による色合いの違い (%1)</translation>
    </message>
    <message>
        <source>the function jumps there (%1)</source>
        <translation>関数がそこで跳ぶ (%1)</translation>
    </message>
    <message>
        <source>outline: a part of a pixel (%1)</source>
        <translation>輪郭: ピクセルの一部 (%1)</translation>
    </message>
    <message>
        <source>not shown here, see Problems (%1)</source>
        <translation>ここでは表示されない、「問題」を参照 (%1)</translation>
    </message>
    <message>
        <source>for another reason (%1)</source>
        <translation>その他の理由 (%1)</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Type a function of x, y, z in POV-Ray&apos;s language and see its surface at once.</source>
        <translation>x, y, z の関数を POV-Ray の言語で入力すると、その曲面がすぐに見えます。</translation>
    </message>
    <message>
        <source>Write a picture of the window to OUT.png as soon as everything is drawn, then end.</source>
        <translation>すべて描き終えたらウィンドウの画像を OUT.png に書き、終了します。</translation>
    </message>
    <message>
        <source>Size of the window.</source>
        <translation>ウィンドウの大きさ。</translation>
    </message>
    <message>
        <source>system, light, dark or high-contrast.</source>
        <translation>system、light、dark、high-contrast のいずれか。</translation>
    </message>
    <message>
        <source>A .pov, .inc or .vl file to open.</source>
        <translation>開く .pov、.inc または .vl ファイル。</translation>
    </message>
    <message>
        <source>A new scene</source>
        <translation>新しいシーン</translation>
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
        <translation>サンプル %1 個、単位距離あたりの上界 %2。</translation>
    </message>
    <message>
        <source>It dismissed the interval from %1 to %2, for it takes f to be no steeper than %3; there it is up to %4.</source>
        <translation>%1 から %2 の区間を捨てました。f の傾きを %3 以下と見なしましたが、実際は %4 に達します。</translation>
    </message>
    <message>
        <source>Nothing is hit. </source>
        <translation>何にも当たりません。</translation>
    </message>
    <message>
        <source>POV-Ray&apos;s method hits at %1, where nothing is. </source>
        <translation>POV-Ray の方法は何もない %1 で当たります。</translation>
    </message>
    <message>
        <source>POV-Ray&apos;s method misses the surface at %1. </source>
        <translation>POV-Ray の方法は %1 の曲面を見落とします。</translation>
    </message>
    <message>
        <source>POV-Ray&apos;s method hits at %1, where nothing is; the surface is at %2. </source>
        <translation>POV-Ray の方法は何もない %1 で当たります。曲面は %2 にあります。</translation>
    </message>
    <message>
        <source>POV-Ray&apos;s method misses the surface at %1 and hits further back, at %2. </source>
        <translation>POV-Ray の方法は %1 の曲面を見落とし、奥の %2 で当たります。</translation>
    </message>
    <message>
        <source>POV-Ray&apos;s method finds the surface at %1, off by %2. </source>
        <translation>POV-Ray の方法は %1 で曲面を見つけ、誤差は %2 です。</translation>
    </message>
    <message>
        <source>Yet its picture has a hole here: it dismisses rays too close to one that missed before.</source>
        <translation>それでも画像のここには穴があります。前に外れたレイに近すぎるレイを捨てるためです。</translation>
    </message>
</context>
<context>
    <name>ShortcutWindow</name>
    <message>
        <source>%1; with Shift: selects</source>
        <translation>%1。Shift を押すと選択</translation>
    </message>
    <message>
        <source>In the picture</source>
        <translation>画像の中</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>回す</translation>
    </message>
    <message>
        <source>Left drag, arrow keys</source>
        <translation>左ドラッグ、矢印キー</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Right or middle drag, Shift+drag, Shift+arrow keys</source>
        <translation>右または中ドラッグ、Shift+ドラッグ、Shift+矢印キー</translation>
    </message>
    <message>
        <source>Come nearer, go away</source>
        <translation>近づく、離れる</translation>
    </message>
    <message>
        <source>Wheel, + and -</source>
        <translation>ホイール、+ と -</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>全体を表示</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>Back to the camera of the text</source>
        <translation>テキストのカメラに戻る</translation>
    </message>
    <message>
        <source>Double click, Home</source>
        <translation>ダブルクリック、Home</translation>
    </message>
    <message>
        <source>Stop the picture</source>
        <translation>画像の計算を停止</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Move the divider of a split view</source>
        <translation>分割ビューの境界を動かす</translation>
    </message>
    <message>
        <source>Drag it, Alt+Left, Alt+Right</source>
        <translation>ドラッグ、Alt+左、Alt+右</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>メニュー</translation>
    </message>
    <message>
        <source>Right click, Menu</source>
        <translation>右クリック、Menu</translation>
    </message>
    <message>
        <source>In the text</source>
        <translation>テキストの中</translation>
    </message>
    <message>
        <source>With the mouse in the text</source>
        <translation>テキストの中でのマウス</translation>
    </message>
    <message>
        <source>Change the number under the mouse</source>
        <translation>マウスの下の数値を変える</translation>
    </message>
    <message>
        <source>Ctrl+drag; Alt+drag and Alt+wheel</source>
        <translation>Ctrl+ドラッグ、Alt+ドラッグ、Alt+ホイール</translation>
    </message>
    <message>
        <source>A tenth of a step, or ten</source>
        <translation>0.1 ステップ、または 10 ステップ</translation>
    </message>
    <message>
        <source>Shift, or the other of Ctrl and Alt, as well</source>
        <translation>さらに Shift、または Ctrl と Alt のもう一方</translation>
    </message>
    <message>
        <source>Take a drag back</source>
        <translation>ドラッグを取り消す</translation>
    </message>
    <message>
        <source>Esc, before the button is released</source>
        <translation>ボタンを離す前に Esc</translation>
    </message>
    <message>
        <source>Size of the letters</source>
        <translation>文字の大きさ</translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation>Ctrl+ホイール</translation>
    </message>
    <message>
        <source>In the panels</source>
        <translation>パネルの中</translation>
    </message>
    <message>
        <source>Parameter: back to its first value</source>
        <translation>パラメータ: 最初の値に戻す</translation>
    </message>
    <message>
        <source>Double click on the name</source>
        <translation>名前をダブルクリック</translation>
    </message>
    <message>
        <source>Parameter: another end of its range</source>
        <translation>パラメータ: 範囲の端を変える</translation>
    </message>
    <message>
        <source>Double click on the end</source>
        <translation>端をダブルクリック</translation>
    </message>
    <message>
        <source>Cross-section: shift, zoom, see all</source>
        <translation>断面: 移動、ズーム、全体表示</translation>
    </message>
    <message>
        <source>Drag, wheel, double click</source>
        <translation>ドラッグ、ホイール、ダブルクリック</translation>
    </message>
    <message>
        <source>Help: the page before, the next one</source>
        <translation>ヘルプ: 前のページ、次のページ</translation>
    </message>
    <message>
        <source>Alt+Left, Alt+Right</source>
        <translation>Alt+左、Alt+右</translation>
    </message>
    <message>
        <source>Help: back to the text</source>
        <translation>ヘルプ: テキストに戻る</translation>
    </message>
</context>
<context>
    <name>StudyPanels</name>
    <message>
        <source>The threshold does not stand in the text itself; it is not changed.</source>
        <translation>しきい値はこのテキスト自体にないため、変更しません。</translation>
    </message>
    <message>
        <source>Cross-section</source>
        <translation>断面</translation>
    </message>
    <message>
        <source>&lt;p&gt;The function on a plane: blue is inside the solid, orange outside, the bold line is the surface.&lt;/p&gt;</source>
        <translation>&lt;p&gt;平面上の関数です。青は立体の内側、橙は外側、太線は曲面です。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation>勾配</translation>
    </message>
    <message>
        <source>&lt;p&gt;How steep the function is, and what max_gradient has to be for a picture without holes: with proof.&lt;/p&gt;</source>
        <translation>&lt;p&gt;関数の傾きと、穴のない画像に必要な max_gradient を、証明付きで示します。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation>ヒストグラム</translation>
    </message>
    <message>
        <source>&lt;p&gt;How much of the container and of the surface is how steep: where a smaller max_gradient would begin to lose pixels.&lt;/p&gt;</source>
        <translation>&lt;p&gt;コンテナと曲面のどれだけがどの傾きを持つか、max_gradient をどこまで下げるとピクセルを失い始めるかを示します。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>レベル</translation>
    </message>
    <message>
        <source>&lt;p&gt;How often the function takes which value, and the thresholds at which pieces of the surface appear, join or get tunnels: with proof.&lt;/p&gt;</source>
        <translation>&lt;p&gt;関数がどの値をどれだけ取るか、どのしきい値で曲面の部分が現れ、つながり、トンネルができるかを、証明付きで示します。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>精度</translation>
    </message>
    <message>
        <source>&lt;p&gt;What accuracy and max_gradient cost in time, and lose in pixels, over a range of values.&lt;/p&gt;</source>
        <translation>&lt;p&gt;accuracy と max_gradient にかかる時間と失うピクセルを、値の範囲にわたって示します。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Sweep</source>
        <translation>スイープ</translation>
    </message>
    <message>
        <source>&lt;p&gt;What the values of a number cost in evaluations, how steep they make the function, and into how many pieces, tunnels and hollows: over a range of values.&lt;/p&gt;</source>
        <translation>&lt;p&gt;数値の各値にかかる評価回数、関数の傾き、部分・トンネル・空洞の数を、値の範囲にわたって示します。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>レポート</translation>
    </message>
    <message>
        <source>&lt;p&gt;What the solid is like: pieces, tunnels, extent, volume, area, walls and symmetry, in sentences; and the health of the function: where it has no value, bound, slope or digits.&lt;/p&gt;</source>
        <translation>&lt;p&gt;立体の部分、トンネル、広がり、体積、面積、壁、対称性を文で示し、関数の健全性、つまり値、上界、傾き、有効桁がない場所を示します。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Ray</source>
        <translation>レイ</translation>
    </message>
    <message>
        <source>&lt;p&gt;The function along the line of sight through one pixel: where the surface is met, and what POV-Ray stepped over.&lt;/p&gt;</source>
        <translation>&lt;p&gt;1 ピクセルを通る視線に沿った関数です。曲面に当たる所と、POV-Ray が飛び越えた所を示します。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Effects</source>
        <translation>効果</translation>
    </message>
    <message>
        <source>&lt;p&gt;What the picture is made of, what each part costs, and switches for them.&lt;/p&gt;</source>
        <translation>&lt;p&gt;画像が何からできているか、各部分のコスト、その切り替え。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>シート</translation>
    </message>
    <message>
        <source>&lt;p&gt;The scene in small for values of one number, or of two, as one picture; a click on one of them sets its values.&lt;/p&gt;</source>
        <translation>&lt;p&gt;1 つまたは 2 つの数値の各値での小さなシーンを、1 枚の画像に並べます。どれかをクリックするとその値になります。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Formula</source>
        <translation>式</translation>
    </message>
    <message>
        <source>&lt;p&gt;Quicker or more exact ways to write the function, each with its proof; and its derivatives, with a function whose gradient is 1 on the surface, as text.&lt;/p&gt;</source>
        <translation>&lt;p&gt;関数をより速く、またはより正確に書く方法を、それぞれ証明付きで示します。導関数と、曲面上で勾配が 1 になる関数もテキストとして得られます。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Evaluate</source>
        <translation>Evaluate</translation>
    </message>
    <message>
        <source>&lt;p&gt;Whether evaluate pays for an isosurface in this view, and with which numbers: measured cost and lost pixels of each.&lt;/p&gt;</source>
        <translation>&lt;p&gt;このビューの等値面で evaluate が得になるか、どの数値がよいかを、それぞれ測定したコストと失われるピクセルで示します。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>修復</translation>
    </message>
    <message>
        <source>&lt;p&gt;Every isosurface of the scene and its include files: what its max_gradient is worth, and what it should be, with proof; one click writes what is ticked.&lt;/p&gt;</source>
        <translation>&lt;p&gt;シーンとインクルードファイルのすべての等値面: max_gradient の良し悪しと、証明付きのあるべき値。ワンクリックでチェックした値を書き込みます。&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>TimelineRow</name>
    <message>
        <source>%1 = %2 at frame %3</source>
        <translation>フレーム %3 で %1 = %2</translation>
    </message>
    <message>
        <source>, then %1</source>
        <translation>、次に%1</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>なめらか</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>一定</translation>
    </message>
    <message>
        <source>Slow start</source>
        <translation>ゆっくり開始</translation>
    </message>
    <message>
        <source>Slow end</source>
        <translation>ゆっくり終了</translation>
    </message>
    <message>
        <source>Curve through the keys</source>
        <translation>キーを通る曲線</translation>
    </message>
    <message>
        <source>Hold, then jump</source>
        <translation>保持して跳ぶ</translation>
    </message>
</context>
<context>
    <name>VerdictOverlay</name>
    <message>
        <source>the surface: proven</source>
        <translation>曲面: 証明済み</translation>
    </message>
    <message>
        <source>nothing there: proven</source>
        <translation>何もない: 証明済み</translation>
    </message>
    <message>
        <source>unproven: proven but for places below accuracy/100 (a gap)</source>
        <translation>未証明: accuracy/100 未満の場所を除き証明済み (すき間)</translation>
    </message>
    <message>
        <source>unproven: took too long, so the rest of the ray was sampled</source>
        <translation>未証明: 時間切れのため、レイの残りはサンプリング</translation>
    </message>
    <message>
        <source>unproven: no bounds of the function are known</source>
        <translation>未証明: 関数の上下界が不明</translation>
    </message>
    <message>
        <source>%1 proven</source>
        <translation>%1 証明済み</translation>
    </message>
    <message>
        <source>1 unproven pixel</source>
        <translation>未証明 1 ピクセル</translation>
    </message>
    <message>
        <source>%1 unproven pixels</source>
        <translation>未証明 %1 ピクセル</translation>
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
        <translation>跳び</translation>
    </message>
    <message>
        <source>an infinite slope</source>
        <translation>無限の傾き</translation>
    </message>
    <message>
        <source>a pole</source>
        <translation>極</translation>
    </message>
    <message>
        <source>an overflow</source>
        <translation>オーバーフロー</translation>
    </message>
    <message>
        <source>an unknown bound</source>
        <translation>未知の上界</translation>
    </message>
    <message>
        <source>being proven</source>
        <translation>証明中</translation>
    </message>
    <message>
        <source>no holes</source>
        <translation>穴なし</translation>
    </message>
    <message>
        <source>slower than need be</source>
        <translation>必要以上に遅い</translation>
    </message>
    <message>
        <source>infinitely steep</source>
        <translation>傾きが無限</translation>
    </message>
    <message>
        <source>not proven</source>
        <translation>未証明</translation>
    </message>
    <message>
        <source>holes</source>
        <translation>穴あり</translation>
    </message>
    <message>
        <source>may have holes</source>
        <translation>穴の可能性</translation>
    </message>
    <message>
        <source>Whether POV-Ray&apos;s picture has holes here is being found out.</source>
        <translation>POV-Ray の画像のここに穴があるか調べています。</translation>
    </message>
    <message>
        <source>POV-Ray&apos;s picture has holes: it gets %1 of this view wrong.</source>
        <translation>POV-Ray の画像に穴があります。このビューの %1 が誤りです。</translation>
    </message>
    <message>
        <source>POV-Ray&apos;s picture has no holes here, from wherever you look.</source>
        <translation>どこから見ても、POV-Ray の画像のここに穴はありません。</translation>
    </message>
    <message>
        <source>POV-Ray takes %1 times as long for this view as it has to.</source>
        <translation>POV-Ray はこのビューに必要な時間の %1 倍かかります。</translation>
    </message>
    <message>
        <source>POV-Ray may take longer than it has to.</source>
        <translation>POV-Ray は必要以上に時間がかかるかもしれません。</translation>
    </message>
    <message>
        <source>No holes in this view; other views may have some, whatever the setting.</source>
        <translation>このビューに穴はありません。ほかのビューでは、どの設定でも穴がありえます。</translation>
    </message>
    <message>
        <source>The function is infinitely steep somewhere: views may have holes.</source>
        <translation>関数の傾きがどこかで無限です。ビューに穴がありえます。</translation>
    </message>
    <message>
        <source>No holes in this view; whether others have some is not proven.</source>
        <translation>このビューに穴はありません。ほかのビューについては未証明です。</translation>
    </message>
    <message>
        <source>Whether POV-Ray&apos;s picture has holes is not proven.</source>
        <translation>POV-Ray の画像に穴があるかは未証明です。</translation>
    </message>
    <message>
        <source>No holes in this view; other views may have some.</source>
        <translation>このビューに穴はありません。ほかのビューにはありえます。</translation>
    </message>
    <message>
        <source>POV-Ray&apos;s picture may have holes.</source>
        <translation>POV-Ray の画像に穴があるかもしれません。</translation>
    </message>
    <message>
        <source>max_gradient is %1, but the gradient has no bound: %2 at %3.</source>
        <translation>max_gradient は %1 ですが、勾配に上界がありません: %3 で %2。</translation>
    </message>
    <message>
        <source>max_gradient is %1, but the gradient is %2 at %3.</source>
        <translation>max_gradient は %1 ですが、%3 での勾配は %2 です。</translation>
    </message>
    <message>
        <source>max_gradient is %1; the function may jump somewhere.</source>
        <translation>max_gradient は %1 です。関数はどこかで跳ぶかもしれません。</translation>
    </message>
    <message>
        <source>max_gradient is %1; the gradient is at least %2, and nothing is known above that.</source>
        <translation>max_gradient は %1 です。勾配は少なくとも %2 で、それより上は不明です。</translation>
    </message>
    <message>
        <source>max_gradient is %1; the largest gradient lies between %2 and %3.</source>
        <translation>max_gradient は %1 です。最大の勾配は %2 と %3 の間です。</translation>
    </message>
    <message>
        <source>max_gradient is %1; it is proven that no gradient exceeds %2.</source>
        <translation>max_gradient は %1 です。勾配が %2 を超えないことは証明済みです。</translation>
    </message>
</context>
<context>
    <name>isoscope::AboutDialog</name>
    <message>
        <source>About Isoscope</source>
        <translation>Isoscope について</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Isoscope %1&lt;/h3&gt;&lt;p&gt;An instrument for isosurfaces: type a function of x, y, z in POV-Ray&apos;s language and see its surface at once.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later; without any warranty.&lt;/p&gt;&lt;p&gt;With Qt %2, VTK %3, QScintilla, oneTBB, Highway, SLEEF and GLM. POV-Ray is a trademark of its owner; this program contains none of its code.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Isoscope %1&lt;/h3&gt;&lt;p&gt;等値面のための道具です。x, y, z の関数を POV-Ray の言語で入力すると、その曲面がすぐに見えます。&lt;/p&gt;&lt;p&gt;GNU General Public License バージョン 3 以降に従う自由ソフトウェアで、一切の保証はありません。&lt;/p&gt;&lt;p&gt;Qt %2、VTK %3、QScintilla、oneTBB、Highway、SLEEF、GLM を使用。POV-Ray は所有者の商標であり、このプログラムはそのコードを含みません。&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>isoscope::AccuracyPanel</name>
    <message>
        <source>The setting whose values are tried</source>
        <translation>値を試す設定</translation>
    </message>
    <message>
        <source>Setting that is studied</source>
        <translation>調べる設定</translation>
    </message>
    <message>
        <source>Measure or stop</source>
        <translation>測定または停止</translation>
    </message>
    <message>
        <source>Progress of the measurement</source>
        <translation>測定の進み具合</translation>
    </message>
    <message>
        <source>How much of the measurement is done</source>
        <translation>測定がどこまで進んだか</translation>
    </message>
    <message>
        <source>About the measurement</source>
        <translation>測定について</translation>
    </message>
    <message>
        <source>accuracy study</source>
        <translation>精度の調査</translation>
    </message>
    <message>
        <source>CPU seconds of the picture</source>
        <translation>画像の CPU 秒</translation>
    </message>
    <message>
        <source>Evaluations per pixel</source>
        <translation>ピクセルあたりの評価回数</translation>
    </message>
    <message>
        <source>What the left chart shows</source>
        <translation>左のグラフの内容</translation>
    </message>
    <message>
        <source>Pixels missed</source>
        <translation>失われたピクセル</translation>
    </message>
    <message>
        <source>Pixels wrong in any way</source>
        <translation>何らかの誤りのあるピクセル</translation>
    </message>
    <message>
        <source>Worst error in t</source>
        <translation>t の最大誤差</translation>
    </message>
    <message>
        <source>Mean error in t</source>
        <translation>t の平均誤差</translation>
    </message>
    <message>
        <source>What the right chart shows</source>
        <translation>右のグラフの内容</translation>
    </message>
    <message>
        <source>Click to write a value into the text</source>
        <translation>クリックで値をテキストに書く</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Measure Again</source>
        <translation>再測定</translation>
    </message>
    <message>
        <source>End the measurement; what is measured stays</source>
        <translation>測定を終える。測定済みの分は残ります</translation>
    </message>
    <message>
        <source>Render the view with nine values, three times each</source>
        <translation>9 個の値で各 3 回ビューを計算する</translation>
    </message>
    <message>
        <source>It is measured as soon as nothing moves.</source>
        <translation>何も動かなくなると測定します。</translation>
    </message>
    <message>
        <source>The scene has no isosurface to measure.</source>
        <translation>測定する等値面がシーンにありません。</translation>
    </message>
    <message>
        <source>POV-Ray</source>
        <translation>POV-Ray</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>正確</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>現在 %1</translation>
    </message>
    <message>
        <source>Chart over %1</source>
        <translation>%1 に対するグラフ</translation>
    </message>
    <message>
        <source>Choosing the size of the picture…</source>
        <translation>画像の大きさを選んでいます…</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 ピクセル</translation>
    </message>
    <message>
        <source>Measured before the last change of scene or view.</source>
        <translation>シーンやビューの最後の変更より前の測定です。</translation>
    </message>
    <message>
        <source>%1; stopped early.</source>
        <translation>%1。途中で停止。</translation>
    </message>
    <message>
        <source>%1, median of 3 runs</source>
        <translation>%1、3 回の中央値</translation>
    </message>
    <message>
        <source>Click for %1 %2.</source>
        <translation>クリックで %1 を %2 に。</translation>
    </message>
</context>
<context>
    <name>isoscope::Actions</name>
    <message>
        <source>Inc&amp;lude Folders…</source>
        <translation>インクルードフォルダ(&amp;L)…</translation>
    </message>
    <message>
        <source>Where #include looks besides the folder of the file</source>
        <translation>#include がファイルのフォルダのほかに探す場所</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>ヘルプ(&amp;H)</translation>
    </message>
    <message>
        <source>Open the page about the word at the caret, or about the panel with the focus</source>
        <translation>カーソル位置の単語、またはフォーカスのあるパネルのページを開く</translation>
    </message>
    <message>
        <source>&amp;Lessons</source>
        <translation>レッスン(&amp;L)</translation>
    </message>
    <message>
        <source>Open the list of short lessons about isosurfaces</source>
        <translation>等値面についての短いレッスンの一覧を開く</translation>
    </message>
    <message>
        <source>&amp;Commands…</source>
        <translation>コマンド(&amp;C)…</translation>
    </message>
    <message>
        <source>Find a command of the menus by words and run it</source>
        <translation>メニューのコマンドを単語で探して実行する</translation>
    </message>
    <message>
        <source>&amp;Keyboard Shortcuts</source>
        <translation>キーボードショートカット(&amp;K)</translation>
    </message>
    <message>
        <source>All commands and their keys</source>
        <translation>すべてのコマンドとキー</translation>
    </message>
    <message>
        <source>&amp;What Is This?</source>
        <translation>これは何(&amp;W)</translation>
    </message>
    <message>
        <source>Click anything of the window to hear what it is</source>
        <translation>ウィンドウの何かをクリックすると説明が出ます</translation>
    </message>
    <message>
        <source>&amp;About Isoscope</source>
        <translation>Isoscope について(&amp;A)</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>バージョンとライセンス</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>新規(&amp;N)</translation>
    </message>
    <message>
        <source>Start with an empty scene</source>
        <translation>空のシーンから始める</translation>
    </message>
    <message>
        <source>New &amp;Window</source>
        <translation>新しいウィンドウ(&amp;W)</translation>
    </message>
    <message>
        <source>Open another window with a document of its own</source>
        <translation>独自の文書を持つ別のウィンドウを開く</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>開く(&amp;O)…</translation>
    </message>
    <message>
        <source>Open a scene or include file</source>
        <translation>シーンまたはインクルードファイルを開く</translation>
    </message>
    <message>
        <source>Start Pa&amp;ge</source>
        <translation>スタートページ(&amp;G)</translation>
    </message>
    <message>
        <source>Choose a scene to begin with, by its picture</source>
        <translation>画像を見て最初のシーンを選ぶ</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save the text</source>
        <translation>テキストを保存する</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>名前を付けて保存(&amp;A)…</translation>
    </message>
    <message>
        <source>Save the text under another name</source>
        <translation>テキストを別の名前で保存する</translation>
    </message>
    <message>
        <source>&amp;Kept Texts…</source>
        <translation>保管テキスト(&amp;K)…</translation>
    </message>
    <message>
        <source>List the texts that were kept because they were not saved</source>
        <translation>保存されずに保管されたテキストの一覧</translation>
    </message>
    <message>
        <source>Fo&amp;llow Another Editor</source>
        <translation>別のエディタに追従(&amp;L)</translation>
    </message>
    <message>
        <source>Take over what another program saves to the file, while the text has no changes here</source>
        <translation>ここで変更がない間、別のプログラムがファイルに保存した内容を取り込む</translation>
    </message>
    <message>
        <source>Copy &amp;Isosurface</source>
        <translation>等値面をコピー(&amp;I)</translation>
    </message>
    <message>
        <source>Copy the isosurface at the caret, with the declarations it needs</source>
        <translation>カーソル位置の等値面を、必要な宣言とともにコピーする</translation>
    </message>
    <message>
        <source>Cop&amp;y Picture</source>
        <translation>画像をコピー(&amp;Y)</translation>
    </message>
    <message>
        <source>Copy the picture as it is shown; Ctrl and the mouse drag it out of the window</source>
        <translation>表示どおりに画像をコピーする。Ctrl とマウスでウィンドウの外へドラッグできます</translation>
    </message>
    <message>
        <source>Copy &amp;Difference Surface</source>
        <translation>差の曲面をコピー(&amp;D)</translation>
    </message>
    <message>
        <source>Copy the isosurface that is 0 where the kept function and the present one agree (View, Overlay, Compare A/B)</source>
        <translation>保管した関数と現在の関数が一致する所で 0 になる等値面をコピーする (表示、重ね表示、A/B 比較)</translation>
    </message>
    <message>
        <source>Isosurface as Include &amp;File…</source>
        <translation>等値面をインクルードファイルに(&amp;F)…</translation>
    </message>
    <message>
        <source>Write the isosurface at the caret, with the declarations it needs, to an .inc file</source>
        <translation>カーソル位置の等値面を、必要な宣言とともに .inc ファイルに書く</translation>
    </message>
    <message>
        <source>Complete &amp;Scene for POV-Ray…</source>
        <translation>POV-Ray 用の完全なシーン(&amp;S)…</translation>
    </message>
    <message>
        <source>Write a .pov file that POV-Ray renders to the picture of the viewport</source>
        <translation>POV-Ray がビューポートの画像を描く .pov ファイルを書く</translation>
    </message>
    <message>
        <source>Objects for &amp;VirtuaLight…</source>
        <translation>VirtuaLight 用オブジェクト(&amp;V)…</translation>
    </message>
    <message>
        <source>Write a .vl file of the objects that VirtuaLight&apos;s notation can say</source>
        <translation>VirtuaLight の記法で表せるオブジェクトの .vl ファイルを書く</translation>
    </message>
    <message>
        <source>I&amp;mage…</source>
        <translation>画像(&amp;M)…</translation>
    </message>
    <message>
        <source>Render the view to a PNG or OpenEXR file of any size</source>
        <translation>ビューを任意の大きさの PNG または OpenEXR ファイルに書く</translation>
    </message>
    <message>
        <source>Pictures in the Ma&amp;king…</source>
        <translation>計算中の画像(&amp;K)…</translation>
    </message>
    <message>
        <source>List the images that are being rendered, and stop them</source>
        <translation>計算中の画像を一覧し、停止する</translation>
    </message>
    <message>
        <source>&amp;Animation for POV-Ray…</source>
        <translation>POV-Ray 用アニメーション(&amp;A)…</translation>
    </message>
    <message>
        <source>Write a .pov file whose numbers follow clock as the timeline has them, and its .ini file</source>
        <translation>数値がタイムラインどおりに clock に従う .pov ファイルと、その .ini ファイルを書く</translation>
    </message>
    <message>
        <source>F&amp;rames and Film…</source>
        <translation>フレームと動画(&amp;R)…</translation>
    </message>
    <message>
        <source>Draw the frames of the timeline into pictures, and a film where ffmpeg is installed</source>
        <translation>タイムラインのフレームを画像に描き、ffmpeg があれば動画にする</translation>
    </message>
    <message>
        <source>M&amp;esh…</source>
        <translation>メッシュ(&amp;E)…</translation>
    </message>
    <message>
        <source>Write the isosurfaces as triangles: STL, 3MF, OBJ, PLY, glTF, or for POV-Ray</source>
        <translation>等値面を三角形で書く: STL、3MF、OBJ、PLY、glTF、または POV-Ray 用</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>終了(&amp;Q)</translation>
    </message>
    <message>
        <source>Close the window; unsaved text is kept for the next start</source>
        <translation>ウィンドウを閉じる。未保存のテキストは次回の起動まで保管されます</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>元に戻す(&amp;U)</translation>
    </message>
    <message>
        <source>Take back the last change; a drag of a slider is one change</source>
        <translation>最後の変更を取り消す。スライダーのドラッグは 1 つの変更です</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>やり直し(&amp;R)</translation>
    </message>
    <message>
        <source>Do again what was taken back</source>
        <translation>取り消したものを再び行う</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>切り取り(&amp;T)</translation>
    </message>
    <message>
        <source>Move the selected text to the clipboard</source>
        <translation>選択したテキストをクリップボードに移す</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>コピー(&amp;C)</translation>
    </message>
    <message>
        <source>Copy the selected text to the clipboard</source>
        <translation>選択したテキストをクリップボードにコピーする</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>貼り付け(&amp;P)</translation>
    </message>
    <message>
        <source>Insert the text of the clipboard</source>
        <translation>クリップボードのテキストを挿入する</translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation>すべて選択(&amp;A)</translation>
    </message>
    <message>
        <source>Select the whole text</source>
        <translation>テキスト全体を選択する</translation>
    </message>
    <message>
        <source>&amp;Find…</source>
        <translation>検索(&amp;F)…</translation>
    </message>
    <message>
        <source>Find in the text</source>
        <translation>テキストの中を検索する</translation>
    </message>
    <message>
        <source>Find and R&amp;eplace…</source>
        <translation>検索と置換(&amp;E)…</translation>
    </message>
    <message>
        <source>Find and replace in the text</source>
        <translation>テキストの中を検索して置き換える</translation>
    </message>
    <message>
        <source>Find &amp;Next</source>
        <translation>次を検索(&amp;N)</translation>
    </message>
    <message>
        <source>Go to the next match</source>
        <translation>次の一致へ</translation>
    </message>
    <message>
        <source>Find Pre&amp;vious</source>
        <translation>前を検索(&amp;V)</translation>
    </message>
    <message>
        <source>Go to the match before</source>
        <translation>前の一致へ</translation>
    </message>
    <message>
        <source>To&amp;ggle Comment</source>
        <translation>コメントの切り替え(&amp;G)</translation>
    </message>
    <message>
        <source>Turn the selected lines into comments, or back</source>
        <translation>選択した行をコメントにする、または戻す</translation>
    </message>
    <message>
        <source>Ad&amp;just Number…</source>
        <translation>数値を調整(&amp;J)…</translation>
    </message>
    <message>
        <source>Open a slider for the number at the caret</source>
        <translation>カーソル位置の数値のスライダーを開く</translation>
    </message>
    <message>
        <source>F&amp;it Container</source>
        <translation>コンテナを合わせる(&amp;I)</translation>
    </message>
    <message>
        <source>Give the isosurface at the caret the smallest container that is proven to show the same; POV-Ray looks for roots only inside</source>
        <translation>カーソル位置の等値面に、同じ表示になると証明された最小のコンテナを与える。POV-Ray はその内側だけで根を探します</translation>
    </message>
    <message>
        <source>&amp;Function…</source>
        <translation>関数(&amp;F)…</translation>
    </message>
    <message>
        <source>Search the built-in functions and insert one</source>
        <translation>組み込み関数を探して挿入する</translation>
    </message>
    <message>
        <source>&amp;Fit View</source>
        <translation>全体を表示(&amp;F)</translation>
    </message>
    <message>
        <source>Show everything that is there, whole; F alone does it in the picture</source>
        <translation>あるものすべてを収めて表示する。画像の中では F だけで動作します</translation>
    </message>
    <message>
        <source>From the F&amp;ront</source>
        <translation>正面から(&amp;R)</translation>
    </message>
    <message>
        <source>Look at everything from the front</source>
        <translation>全体を正面から見る</translation>
    </message>
    <message>
        <source>From A&amp;bove</source>
        <translation>上から(&amp;B)</translation>
    </message>
    <message>
        <source>Look at everything from above</source>
        <translation>全体を上から見る</translation>
    </message>
    <message>
        <source>From the Rig&amp;ht</source>
        <translation>右から(&amp;H)</translation>
    </message>
    <message>
        <source>Look at everything from the right side</source>
        <translation>全体を右側から見る</translation>
    </message>
    <message>
        <source>&amp;As the Text Says</source>
        <translation>テキストのとおり(&amp;A)</translation>
    </message>
    <message>
        <source>Go back to the camera of the text</source>
        <translation>テキストのカメラに戻る</translation>
    </message>
    <message>
        <source>&amp;Write View into Text</source>
        <translation>ビューをテキストに書く(&amp;W)</translation>
    </message>
    <message>
        <source>Make the present view the camera block of the text</source>
        <translation>現在のビューをテキストの camera ブロックにする</translation>
    </message>
    <message>
        <source>Re&amp;draw</source>
        <translation>再描画(&amp;D)</translation>
    </message>
    <message>
        <source>Render the picture again</source>
        <translation>画像を計算し直す</translation>
    </message>
    <message>
        <source>Update W&amp;hile Typing</source>
        <translation>入力中に更新(&amp;H)</translation>
    </message>
    <message>
        <source>Show what is typed after a moment; else when it is saved, or on Redraw</source>
        <translation>入力内容を少し後に表示する。オフなら保存時または再描画時</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
    <message>
        <source>Stop the picture in the making</source>
        <translation>計算中の画像を停止する</translation>
    </message>
    <message>
        <source>S&amp;mooth Edges</source>
        <translation>なめらかな縁(&amp;M)</translation>
    </message>
    <message>
        <source>Render the resting picture with anti-aliasing; takes longer</source>
        <translation>静止画像をアンチエイリアスで描く。時間がかかります</translation>
    </message>
    <message>
        <source>E&amp;xact</source>
        <translation>正確(&amp;X)</translation>
    </message>
    <message>
        <source>Show the surface as it is, without holes; the certified root finder proves it</source>
        <translation>曲面を穴なしでありのままに表示する。保証付き求根法が証明します</translation>
    </message>
    <message>
        <source>As PO&amp;V-Ray</source>
        <translation>POV-Ray のように(&amp;V)</translation>
    </message>
    <message>
        <source>Show what POV-Ray will draw, holes included, with the text&apos;s max_gradient and accuracy</source>
        <translation>POV-Ray が描くものを、テキストの max_gradient と accuracy で、穴も含めて表示する</translation>
    </message>
    <message>
        <source>Containe&amp;r Outlines</source>
        <translation>コンテナの枠(&amp;R)</translation>
    </message>
    <message>
        <source>Draw the containers of the isosurfaces over the picture</source>
        <translation>等値面のコンテナを画像の上に描く</translation>
    </message>
    <message>
        <source>Container</source>
        <translation>コンテナ</translation>
    </message>
    <message>
        <source>Ax&amp;es</source>
        <translation>座標軸(&amp;E)</translation>
    </message>
    <message>
        <source>Draw the axes of the scene, and how the view is turned</source>
        <translation>シーンの座標軸とビューの向きを描く</translation>
    </message>
    <message>
        <source>&amp;Cut Faces</source>
        <translation>切断面(&amp;C)</translation>
    </message>
    <message>
        <source>Hatch where a container cuts its isosurface; that face is no surface of the function</source>
        <translation>コンテナが等値面を切る所に斜線を引く。その面は関数の曲面ではありません</translation>
    </message>
    <message>
        <source>Show &amp;Unproven Pixels</source>
        <translation>未証明ピクセルを表示(&amp;U)</translation>
    </message>
    <message>
        <source>Mark the pixels of the exact picture that are not proven to be right</source>
        <translation>正確な画像のうち、正しいと証明されていないピクセルに印を付ける</translation>
    </message>
    <message>
        <source>Unproven</source>
        <translation>未証明</translation>
    </message>
    <message>
        <source>&amp;System</source>
        <translation>システム(&amp;S)</translation>
    </message>
    <message>
        <source>Light or dark as the desktop is</source>
        <translation>デスクトップに合わせて明るく、または暗く</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>ライト(&amp;L)</translation>
    </message>
    <message>
        <source>Light colours</source>
        <translation>明るい色</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>ダーク(&amp;D)</translation>
    </message>
    <message>
        <source>Dark colours</source>
        <translation>暗い色</translation>
    </message>
    <message>
        <source>High &amp;Contrast</source>
        <translation>ハイコントラスト(&amp;C)</translation>
    </message>
    <message>
        <source>White on black, with outlines; text of at least 7:1</source>
        <translation>黒地に白、輪郭付き。文字は 7:1 以上</translation>
    </message>
    <message>
        <source>Wrap Lon&amp;g Lines</source>
        <translation>長い行を折り返す(&amp;G)</translation>
    </message>
    <message>
        <source>Continue lines of the text that are too long for its panel on the next row</source>
        <translation>パネルに収まらないテキストの行を次の段に続ける</translation>
    </message>
    <message>
        <source>&amp;Browse Gallery</source>
        <translation>ギャラリー(&amp;B)</translation>
    </message>
    <message>
        <source>Choose among functions, examples and your own scenes, with pictures</source>
        <translation>関数、例、自分のシーンから画像を見て選ぶ</translation>
    </message>
    <message>
        <source>Ne&amp;xt Panel</source>
        <translation>次のパネル(&amp;X)</translation>
    </message>
    <message>
        <source>Go to the next of panels, picture and tool bars</source>
        <translation>パネル、画像、ツールバーの次へ移る</translation>
    </message>
    <message>
        <source>Pre&amp;vious Panel</source>
        <translation>前のパネル(&amp;V)</translation>
    </message>
    <message>
        <source>Go to the one before of panels, picture and tool bars</source>
        <translation>パネル、画像、ツールバーの前へ移る</translation>
    </message>
    <message>
        <source>Reset La&amp;yout</source>
        <translation>配置を元に戻す(&amp;Y)</translation>
    </message>
    <message>
        <source>Put all panels back to their places</source>
        <translation>すべてのパネルを元の場所に戻す</translation>
    </message>
    <message>
        <source>&amp;Larger</source>
        <translation>大きく(&amp;L)</translation>
    </message>
    <message>
        <source>Larger letters in the text</source>
        <translation>テキストの文字を大きくする</translation>
    </message>
    <message>
        <source>&amp;Smaller</source>
        <translation>小さく(&amp;S)</translation>
    </message>
    <message>
        <source>Smaller letters in the text</source>
        <translation>テキストの文字を小さくする</translation>
    </message>
    <message>
        <source>&amp;Normal</source>
        <translation>標準(&amp;N)</translation>
    </message>
    <message>
        <source>Letters of the usual size</source>
        <translation>標準の大きさの文字</translation>
    </message>
    <message>
        <source>Everything at %1 %</source>
        <translation>全体を %1 %</translation>
    </message>
    <message>
        <source>Letters, icons and marks of the whole window at %1 % of the desktop&apos;s size</source>
        <translation>ウィンドウ全体の文字、アイコン、印をデスクトップの %1 % の大きさにする</translation>
    </message>
    <message>
        <source>Texts of the window in this language, from the next start on</source>
        <translation>次回の起動からウィンドウをこの言語で表示します</translation>
    </message>
    <message>
        <source>&amp;The System&apos;s Language</source>
        <translation>システムの言語(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>なし(&amp;N)</translation>
    </message>
    <message>
        <source>Show the picture alone</source>
        <translation>画像だけを表示する</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>重ね表示</translation>
    </message>
    <message>
        <source>&amp;Holes</source>
        <translation>穴(&amp;H)</translation>
    </message>
    <message>
        <source>Mark the holes of POV-Ray&apos;s picture: pixels lost, gained or found at a wrong place</source>
        <translation>POV-Ray の画像の穴に印を付ける: 消失、余分、位置違いのピクセル</translation>
    </message>
    <message>
        <source>S&amp;plit View</source>
        <translation>分割ビュー(&amp;P)</translation>
    </message>
    <message>
        <source>POV-Ray&apos;s picture left of a divider, the exact one right of it</source>
        <translation>境界の左に POV-Ray の画像、右に正確な画像</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>分割</translation>
    </message>
    <message>
        <source>&amp;Difference Only</source>
        <translation>差だけ(&amp;D)</translation>
    </message>
    <message>
        <source>What POV-Ray&apos;s picture gets wrong, without the picture</source>
        <translation>POV-Ray の画像の誤りだけを、画像なしで表示する</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>差</translation>
    </message>
    <message>
        <source>&amp;Gradient</source>
        <translation>勾配(&amp;G)</translation>
    </message>
    <message>
        <source>How steep the function is on the surface, as a share of max_gradient</source>
        <translation>曲面上での関数の傾きを、max_gradient に対する割合で表示する</translation>
    </message>
    <message>
        <source>&amp;Beside POV-Ray Itself</source>
        <translation>POV-Ray 本体と並べる(&amp;B)</translation>
    </message>
    <message>
        <source>Have the installed POV-Ray draw the text: its picture left of a divider, the exact one right</source>
        <translation>インストール済みの POV-Ray でテキストを描く。境界の左がその画像、右が正確な画像</translation>
    </message>
    <message>
        <source>POV-Ray</source>
        <translation>POV-Ray</translation>
    </message>
    <message>
        <source>Difference &amp;from POV-Ray Itself</source>
        <translation>POV-Ray 本体との差(&amp;F)</translation>
    </message>
    <message>
        <source>Have the installed POV-Ray draw the text, and mark what differs, by cause</source>
        <translation>インストール済みの POV-Ray でテキストを描き、違いに原因別の印を付ける</translation>
    </message>
    <message>
        <source>Differs</source>
        <translation>相違</translation>
    </message>
    <message>
        <source>&amp;Compare A/B</source>
        <translation>A/B 比較(&amp;C)</translation>
    </message>
    <message>
        <source>Keep the scene as it is now, and show it left of a divider while you change it</source>
        <translation>現在のシーンを保管し、変更する間、境界の左に表示する</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比較</translation>
    </message>
    <message>
        <source>&amp;Inspect Ray</source>
        <translation>レイを調べる(&amp;I)</translation>
    </message>
    <message>
        <source>Click a pixel to see the function along its ray in the panel “Ray”</source>
        <translation>ピクセルをクリックすると、そのレイに沿った関数をパネル「レイ」に表示します</translation>
    </message>
    <message>
        <source>Ray</source>
        <translation>レイ</translation>
    </message>
    <message>
        <source>Section &amp;Plane</source>
        <translation>断面の平面(&amp;P)</translation>
    </message>
    <message>
        <source>Show the plane of the cross-section in the picture; its square moves it, the ball turns it</source>
        <translation>断面の平面を画像に表示する。四角で移動、球で回転します</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>ファイル(&amp;F)</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>最近のファイル(&amp;R)</translation>
    </message>
    <message>
        <source>Open E&amp;xample</source>
        <translation>例を開く(&amp;X)</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>書き出し(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>編集(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Insert</source>
        <translation>挿入(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>表示(&amp;V)</translation>
    </message>
    <message>
        <source>Loo&amp;k</source>
        <translation>視点(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Overlay</source>
        <translation>重ね表示(&amp;O)</translation>
    </message>
    <message>
        <source>Pa&amp;nels</source>
        <translation>パネル(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>テーマ(&amp;T)</translation>
    </message>
    <message>
        <source>Text Si&amp;ze</source>
        <translation>文字の大きさ(&amp;Z)</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>言語</translation>
    </message>
    <message>
        <source>Show:</source>
        <translation>表示:</translation>
    </message>
    <message>
        <source>C&amp;ost</source>
        <translation>コスト(&amp;O)</translation>
    </message>
    <message>
        <source>What each pixel takes in evaluations of the function, in the colour of its cause</source>
        <translation>各ピクセルにかかる関数の評価回数を、原因の色で表示する</translation>
    </message>
    <message>
        <source>&amp;Comment of What Is Proven</source>
        <translation>証明された内容のコメント(&amp;C)</translation>
    </message>
    <message>
        <source>Put a comment in front of isosurfaces that states the proven bound, method, view and version; it is checked when the text is opened again</source>
        <translation>等値面の前に、証明された上界・方法・視点・バージョンを述べるコメントを置く。テキストを再び開くと検査される</translation>
    </message>
</context>
<context>
    <name>isoscope::AnimationExportDialog</name>
    <message>
        <source>Frames and film</source>
        <translation>フレームと動画</translation>
    </message>
    <message>
        <source>ffmpeg cannot be started.</source>
        <translation>ffmpeg を起動できません。</translation>
    </message>
    <message>
        <source>ffmpeg made no film: %1</source>
        <translation>ffmpeg は動画を作れませんでした: %1</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Width of the frames</source>
        <translation>フレームの幅</translation>
    </message>
    <message>
        <source>Height of the frames</source>
        <translation>フレームの高さ</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大きさ</translation>
    </message>
    <message>
        <source>Smooth edges (anti-aliasing)</source>
        <translation>なめらかな縁 (アンチエイリアス)</translation>
    </message>
    <message>
        <source>Several rays for pixels on edges; takes longer</source>
        <translation>縁のピクセルに複数のレイを使う。時間がかかります</translation>
    </message>
    <message>
        <source>How the names of the pictures begin</source>
        <translation>画像の名前の先頭</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>フォルダ…</translation>
    </message>
    <message>
        <source>Choose the folder of the pictures</source>
        <translation>画像のフォルダを選ぶ</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>The number of the frame and .png follow</source>
        <translation>フレーム番号と .png が続きます</translation>
    </message>
    <message>
        <source>Make a film of them, %1 frames per second</source>
        <translation>動画も作る、毎秒 %1 フレーム</translation>
    </message>
    <message>
        <source>An .mp4 file beside the pictures, made by ffmpeg</source>
        <translation>画像の隣に ffmpeg が作る .mp4 ファイル</translation>
    </message>
    <message>
        <source>ffmpeg is not installed</source>
        <translation>ffmpeg がインストールされていません</translation>
    </message>
    <message>
        <source> (ffmpeg is not installed)</source>
        <translation> (ffmpeg がインストールされていません)</translation>
    </message>
    <message>
        <source>%v of %m frames</source>
        <translation>%v / %m フレーム</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>進み具合</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>描画</translation>
    </message>
    <message>
        <source>Draw all frames and write them</source>
        <translation>すべてのフレームを描いて書き込む</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stop; frames that are written stay</source>
        <translation>停止する。書き込み済みのフレームは残ります</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Close; drawing is stopped</source>
        <translation>閉じる。描画は停止します</translation>
    </message>
    <message>
        <source>Folder of the pictures</source>
        <translation>画像のフォルダ</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>置き換え</translation>
    </message>
    <message>
        <source>There are frames with such names already. Replace them?</source>
        <translation>同じ名前のフレームがあります。置き換えますか?</translation>
    </message>
    <message>
        <source>Please choose how the names begin.</source>
        <translation>名前の先頭を決めてください。</translation>
    </message>
    <message>
        <source>That is more than %1 million pixels.</source>
        <translation>%1 百万ピクセルを超えています。</translation>
    </message>
    <message>
        <source>%1 is no PNG picture: it is not replaced.</source>
        <translation>%1 は PNG 画像ではないため、置き換えません。</translation>
    </message>
    <message>
        <source>%1 cannot be made.</source>
        <translation>%1 を作れません。</translation>
    </message>
    <message>
        <source>Drawing…</source>
        <translation>描画中…</translation>
    </message>
    <message>
        <source>Making the film…</source>
        <translation>動画を作成中…</translation>
    </message>
    <message>
        <source>film: %v of %m frames</source>
        <translation>動画: %v / %m フレーム</translation>
    </message>
    <message>
        <source>Stopped; the frames that are written stay.</source>
        <translation>停止しました。書き込み済みのフレームは残ります。</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>書き込みました: %1</translation>
    </message>
</context>
<context>
    <name>isoscope::ChartSaver</name>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Write the chart, or its numbers, to a file</source>
        <translation>グラフまたはその数値をファイルに書く</translation>
    </message>
    <message>
        <source>Save the chart or its numbers</source>
        <translation>グラフまたはその数値を保存</translation>
    </message>
    <message>
        <source>Chart as &amp;SVG…</source>
        <translation>グラフを SVG で(&amp;S)…</translation>
    </message>
    <message>
        <source>SVG drawings (*.svg)</source>
        <translation>SVG 図 (*.svg)</translation>
    </message>
    <message>
        <source>Chart as &amp;PNG…</source>
        <translation>グラフを PNG で(&amp;P)…</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>PNG 画像 (*.png)</translation>
    </message>
    <message>
        <source>&amp;Numbers (CSV)…</source>
        <translation>数値 (CSV)(&amp;N)…</translation>
    </message>
    <message>
        <source>CSV tables (*.csv)</source>
        <translation>CSV 表 (*.csv)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 を保存しました。</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>%1 に書き込めません。</translation>
    </message>
</context>
<context>
    <name>isoscope::CommandKeys</name>
    <message>
        <source>A command has one combination of keys, not several in a row.</source>
        <translation>コマンドのキーの組み合わせは 1 つだけで、連続はできません。</translation>
    </message>
    <message>
        <source>These keys belong to the text: %1.</source>
        <translation>このキーはテキストのものです: %1。</translation>
    </message>
    <message>
        <source>A letter alone is text; add Ctrl or Alt.</source>
        <translation>文字だけのキーは入力になります。Ctrl か Alt を加えてください。</translation>
    </message>
</context>
<context>
    <name>isoscope::CommandPalette</name>
    <message>
        <source>Commands</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>&lt;p&gt;Every command of the menus. Type words of its name, or of what it tells of itself, and press Enter.&lt;/p&gt;</source>
        <translation>&lt;p&gt;メニューのすべてのコマンドです。名前または説明にある単語を入力して Enter を押します。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Type a command, then Enter</source>
        <translation>コマンドを入力し Enter</translation>
    </message>
    <message>
        <source>Words of a command</source>
        <translation>コマンドの単語</translation>
    </message>
    <message>
        <source>Lists the commands that these words name</source>
        <translation>これらの単語に合うコマンドを一覧する</translation>
    </message>
    <message>
        <source>Commands with their keys</source>
        <translation>コマンドとキー</translation>
    </message>
    <message>
        <source>The commands of the menus</source>
        <translation>メニューのコマンド</translation>
    </message>
</context>
<context>
    <name>isoscope::ContainerFitter</name>
    <message>
        <source>Looking for the smallest container that is proven to show the same…</source>
        <translation>同じ表示になると証明された最小のコンテナを探しています…</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
    <message>
        <source>Leaves the container as it is</source>
        <translation>コンテナをそのままにする</translation>
    </message>
    <message>
        <source>The text is still being read.</source>
        <translation>テキストを読んでいる途中です。</translation>
    </message>
    <message>
        <source>There is no isosurface in the text.</source>
        <translation>テキストに等値面がありません。</translation>
    </message>
    <message>
        <source>Looking for the smallest container…</source>
        <translation>最小のコンテナを探しています…</translation>
    </message>
    <message>
        <source>Stopped; the container is left alone.</source>
        <translation>停止しました。コンテナはそのままです。</translation>
    </message>
    <message>
        <source>The text has changed; its container is left alone.</source>
        <translation>テキストが変わったため、コンテナはそのままです。</translation>
    </message>
    <message>
        <source>Nothing of this isosurface is in its container.</source>
        <translation>この等値面はコンテナの中に何もありません。</translation>
    </message>
    <message>
        <source>No container is proven to show the same with less room.</source>
        <translation>同じ表示になると証明された、より小さなコンテナはありません。</translation>
    </message>
    <message>
        <source>The isosurface does not stand in the text itself, or stands for several; its container is left alone.</source>
        <translation>等値面はこのテキスト自体にないか、複数を表すため、コンテナはそのままです。</translation>
    </message>
    <message>
        <source>The container has %1 % of its room now; POV-Ray takes about %2 s instead of %3 s at 640 x 480.</source>
        <translation>コンテナは以前の %1 % になりました。POV-Ray は 640 x 480 で約 %3 秒の代わりに約 %2 秒かかります。</translation>
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
        <translation>%1～%2</translation>
    </message>
    <message>
        <source>no time</source>
        <translation>時間なし</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 分</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 時間</translation>
    </message>
    <message>
        <source>What the setting costs in time and loses in pixels over its range; a click sets it.</source>
        <translation>設定の範囲にわたる時間と失うピクセル。クリックで値を設定します。</translation>
    </message>
    <message>
        <source>What each value of the slider above costs and loses. Orange is POV-Ray&apos;s time for a picture, blue the time of this program; both rise upwards by factors. Red below them are lost pixels: holes. The triangle marks the knee: behind it more time changes no pixel. A click sets the value, arrow keys go from one measured value to the next, Return goes to the knee.</source>
        <translation>上のスライダーの各値にかかる時間と失うもの。橙は POV-Ray の画像の時間、青はこのプログラムの時間で、どちらも倍率で上に伸びます。下の赤は失われたピクセル、つまり穴です。三角は折れ点で、その先は時間をかけても変わるピクセルはありません。クリックで値を設定し、矢印キーで測定値を順に移り、Return で折れ点に移ります。</translation>
    </message>
    <message>
        <source>What %1 costs</source>
        <translation>%1 のコスト</translation>
    </message>
    <message>
        <source>POV-Ray %1 ± %2 % at %3</source>
        <translation>POV-Ray %3 で %1 ± %2 %</translation>
    </message>
    <message>
        <source>%1; none lost</source>
        <translation>%1、消失なし</translation>
    </message>
    <message>
        <source>%1; %2 lost</source>
        <translation>%1、消失 %2</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source> (measured before the last change)</source>
        <translation> (最後の変更より前の測定)</translation>
    </message>
    <message>
        <source> (still measuring)</source>
        <translation> (測定中)</translation>
    </message>
    <message>
        <source>At %1: POV-Ray about %2, to %3 %; Isoscope about %4 of processor time</source>
        <translation>%1 では: POV-Ray 約 %2 (±%3 %)、Isoscope プロセッサ時間約 %4</translation>
    </message>
    <message>
        <source>Pixels lost: POV-Ray %1, Isoscope %2, of %3 that were traced</source>
        <translation>失われたピクセル: POV-Ray %1、Isoscope %2 (追跡した %3 のうち)</translation>
    </message>
    <message>
        <source>Knee at %1: finer values cost more and change no pixel of this view</source>
        <translation>折れ点 %1: より細かい値は時間がかかるだけで、このビューのピクセルは変わりません</translation>
    </message>
    <message>
        <source>Knee at %1: larger values cost more and change no pixel of this view</source>
        <translation>折れ点 %1: より大きい値は時間がかかるだけで、このビューのピクセルは変わりません</translation>
    </message>
    <message>
        <source>not measured: not in the picture shown</source>
        <translation>未測定: 表示中の画像にありません</translation>
    </message>
    <message>
        <source>nothing to measure here</source>
        <translation>ここに測定するものはありません</translation>
    </message>
    <message>
        <source>measuring what it costs…</source>
        <translation>コストを測定中…</translation>
    </message>
    <message>
        <source>What each value costs; it is measured as soon as all rests</source>
        <translation>各値のコスト。すべてが静止すると測定します</translation>
    </message>
    <message>
        <source>What each value costs; it is measured once the picture shows it</source>
        <translation>各値のコスト。画像に表示されると測定します</translation>
    </message>
</context>
<context>
    <name>isoscope::DifferenceWindow</name>
    <message>
        <source>%1: the disk and the editor</source>
        <translation>%1: ディスクとエディタ</translation>
    </message>
    <message>
        <source>Differing lines</source>
        <translation>異なる行</translation>
    </message>
    <message>
        <source>Take Theirs</source>
        <translation>相手を採用</translation>
    </message>
    <message>
        <source>Show the text of the disk; Undo brings yours back</source>
        <translation>ディスクのテキストを表示する。元に戻すと自分のテキストに戻ります</translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation>自分を維持</translation>
    </message>
    <message>
        <source>Go on with the text of the editor; saving replaces the file</source>
        <translation>エディタのテキストで続ける。保存するとファイルを置き換えます</translation>
    </message>
    <message>
        <source>Both texts are the same.</source>
        <translation>両方のテキストは同じです。</translation>
    </message>
    <message>
        <source>−  red: lines that stand only on the disk (%1).   +  green: lines that stand only in the editor (%2).</source>
        <translation>−  赤: ディスクだけにある行 (%1)。   +  緑: エディタだけにある行 (%2)。</translation>
    </message>
</context>
<context>
    <name>isoscope::DockTabs</name>
    <message>
        <source>Panels that share this place; right-click to close one or to take it out</source>
        <translation>この場所を共有するパネル。右クリックで閉じる、または取り出す</translation>
    </message>
    <message>
        <source>Panels that share this place</source>
        <translation>この場所を共有するパネル</translation>
    </message>
    <message>
        <source>&amp;Take Out</source>
        <translation>取り出す(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>閉じる(&amp;C)</translation>
    </message>
</context>
<context>
    <name>isoscope::Docks</name>
    <message>
        <source>Show or hide the panel “%1”</source>
        <translation>パネル「%1」を表示または隠す</translation>
    </message>
</context>
<context>
    <name>isoscope::Document</name>
    <message>
        <source>Untitled</source>
        <translation>無題</translation>
    </message>
    <message>
        <source>%1 is a folder.</source>
        <translation>%1 はフォルダです。</translation>
    </message>
    <message>
        <source>%1 is larger than %2 MB: no scene text.</source>
        <translation>%1 は %2 MB を超えており、シーンのテキストではありません。</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>%1 を読めません: %2。</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2.</source>
        <translation>%1 に書き込めません: %2。</translation>
    </message>
</context>
<context>
    <name>isoscope::DocumentController</name>
    <message>
        <source>Scenes (*.pov *.inc *.vl *.vib);;All files (*)</source>
        <translation>シーン (*.pov *.inc *.vl *.vib);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>%1 (kept)</source>
        <translation>%1 (保管)</translation>
    </message>
    <message>
        <source>%1 has changes that are not saved.</source>
        <translation>%1 に保存していない変更があります。</translation>
    </message>
    <message>
        <source>The text is not saved, and it cannot be kept. %1</source>
        <translation>テキストは保存されておらず、保管もできません。%1</translation>
    </message>
    <message>
        <source>The unsaved text is kept; File, Kept Texts brings it back.</source>
        <translation>未保存のテキストを保管しました。ファイル、保管テキストで戻せます。</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Save the text to its file, then go on</source>
        <translation>テキストをファイルに保存して続ける</translation>
    </message>
    <message>
        <source>Keep for Next Time</source>
        <translation>次回まで保管</translation>
    </message>
    <message>
        <source>Leave the file as it is; the text is offered at the next start</source>
        <translation>ファイルはそのままにする。テキストは次回の起動時に示されます</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>破棄</translation>
    </message>
    <message>
        <source>Give the changes up for good</source>
        <translation>変更を完全に捨てる</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Go on with this text</source>
        <translation>このテキストで続ける</translation>
    </message>
    <message>
        <source>Open a scene</source>
        <translation>シーンを開く</translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation>シーンを保存</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>名前を付けて保存…</translation>
    </message>
    <message>
        <source>Save the text under another name</source>
        <translation>テキストを別の名前で保存する</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Hide this line; the text stays here</source>
        <translation>この行を隠す。テキストはここに残ります</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>保存しました: %1</translation>
    </message>
    <message>
        <source>Read again: %1</source>
        <translation>読み直しました: %1</translation>
    </message>
    <message>
        <source>An unsaved text was kept: %1, %2.</source>
        <translation>未保存のテキストが保管されています: %1、%2。</translation>
    </message>
    <message numerus="yes">
        <source>%n unsaved texts were kept, the last one: %1, %2.</source>
        <translation>
            <numerusform>未保存のテキストが %n 個保管されています。最後: %1、%2。</numerusform>
        </translation>
    </message>
    <message>
        <source>Bring Back</source>
        <translation>戻す</translation>
    </message>
    <message>
        <source>Show the last kept text in the editor</source>
        <translation>最後に保管されたテキストをエディタに表示する</translation>
    </message>
    <message>
        <source>Show…</source>
        <translation>表示…</translation>
    </message>
    <message>
        <source>List the kept texts with their first lines</source>
        <translation>保管テキストを最初の行とともに一覧する</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>後で</translation>
    </message>
    <message>
        <source>Keep them, and ask at the next start</source>
        <translation>保管したまま、次回の起動時に尋ねる</translation>
    </message>
    <message>
        <source>%1 is no longer there; the text has no file now.</source>
        <translation>%1 はもうありません。テキストにファイルがなくなりました。</translation>
    </message>
</context>
<context>
    <name>isoscope::EffectsPanel</name>
    <message>
        <source>%1 ms of processor time</source>
        <translation>プロセッサ時間 %1 ms</translation>
    </message>
    <message>
        <source>Some light is cut short; %1</source>
        <translation>光の一部を短縮。%1</translation>
    </message>
    <message>
        <source>%1 rays, %2 evaluations</source>
        <translation>レイ %1、評価 %2</translation>
    </message>
    <message>
        <source>Cost of all stages</source>
        <translation>全段階のコスト</translation>
    </message>
    <message>
        <source>While &amp;moving at most</source>
        <translation>動作中の上限(&amp;M)</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>制限なし</translation>
    </message>
    <message>
        <source>Time for a moving picture</source>
        <translation>動作中の画像の時間</translation>
    </message>
    <message>
        <source>While the view or a number moves, the dearest effects are left out until a picture takes no longer; they come back at rest</source>
        <translation>ビューや数値が動く間、画像がこの時間を超えなくなるまで高価な効果を省きます。静止すると戻ります</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>効果</translation>
    </message>
    <message>
        <source>Rays</source>
        <translation>レイ</translation>
    </message>
    <message>
        <source>Evaluations</source>
        <translation>評価</translation>
    </message>
    <message>
        <source>CPU ms</source>
        <translation>CPU ms</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>理由</translation>
    </message>
    <message>
        <source>Effects of the picture</source>
        <translation>画像の効果</translation>
    </message>
    <message>
        <source>What the picture is made of, and what each part has cost</source>
        <translation>画像が何からできているか、各部分のコスト</translation>
    </message>
    <message>
        <source>Without its mark an effect is left out of this view, never of an exported picture</source>
        <translation>印を外すとこのビューで効果を省きます。書き出す画像では省きません</translation>
    </message>
    <message>
        <source>Stages of drawing, in their order</source>
        <translation>描画の段階、実行順</translation>
    </message>
    <message>
        <source>Rays that the effect has sent</source>
        <translation>効果が送ったレイ</translation>
    </message>
    <message>
        <source>Evaluations of functions that it has caused</source>
        <translation>効果による関数の評価</translation>
    </message>
    <message>
        <source>Processor time of all threads, in milliseconds</source>
        <translation>全スレッドのプロセッサ時間、ミリ秒</translation>
    </message>
    <message>
        <source>What in the scene calls for it, or why nothing does</source>
        <translation>シーンの何がそれを必要とするか、または何も必要としない理由</translation>
    </message>
    <message>
        <source>No picture yet</source>
        <translation>画像はまだありません</translation>
    </message>
    <message>
        <source>Left out of this view. %1</source>
        <translation>このビューでは省略。%1</translation>
    </message>
    <message>
        <source>Left out while moving. %1</source>
        <translation>動作中は省略。%1</translation>
    </message>
    <message>
        <source>%1 roots, %2 misses</source>
        <translation>根 %1、根なし %2</translation>
    </message>
    <message>
        <source>, %1 not certain</source>
        <translation>、不確か %1</translation>
    </message>
</context>
<context>
    <name>isoscope::EmptyTextHint</name>
    <message>
        <source>Type a formula, such as x*x + y*y + z*z - 1, or a scene</source>
        <translation>x*x + y*y + z*z - 1 のような式、またはシーンを入力してください</translation>
    </message>
</context>
<context>
    <name>isoscope::EvaluatePanel</name>
    <message>
        <source>The isosurface whose settings are tried.</source>
        <translation>設定を試す等値面。</translation>
    </message>
    <message>
        <source>Try settings of evaluate, or stop</source>
        <translation>evaluate の設定を試す、または停止</translation>
    </message>
    <message>
        <source>Progress of the trials</source>
        <translation>試行の進み具合</translation>
    </message>
    <message>
        <source>How many of the settings are tried</source>
        <translation>設定をどこまで試したか</translation>
    </message>
    <message>
        <source>Whether evaluate pays</source>
        <translation>evaluate が得になるか</translation>
    </message>
    <message>
        <source>Write Into the Text</source>
        <translation>テキストに書く</translation>
    </message>
    <message>
        <source>Gives the isosurface the chosen setting; Undo takes it back.</source>
        <translation>選んだ設定を等値面に与えます。元に戻すで取り消せます。</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>Evaluations per pixel</source>
        <translation>ピクセルあたりの評価回数</translation>
    </message>
    <message>
        <source>Pixels lost or wrong</source>
        <translation>失われた、または誤ったピクセル</translation>
    </message>
    <message>
        <source>Settings that were tried</source>
        <translation>試した設定</translation>
    </message>
    <message>
        <source>Enter or a double click writes the setting into the text</source>
        <translation>Enter かダブルクリックで設定をテキストに書く</translation>
    </message>
    <message>
        <source>evaluate 0.0000, 0.00, 0.00 (pays most)__</source>
        <translation>evaluate 0.0000, 0.00, 0.00 (最も得)__</translation>
    </message>
    <message>
        <source>Evaluations per pixel__</source>
        <translation>ピクセルあたりの評価回数__</translation>
    </message>
    <message>
        <source>%1 (pays most)</source>
        <translation>%1 (最も得)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Measure Again</source>
        <translation>再測定</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>測定</translation>
    </message>
    <message>
        <source>End the trials</source>
        <translation>試行を終える</translation>
    </message>
    <message>
        <source>Tries numbers of evaluate in a small picture of this view</source>
        <translation>このビューの小さな画像で evaluate の数値を試す</translation>
    </message>
    <message>
        <source>The scene has no isosurface.</source>
        <translation>シーンに等値面がありません。</translation>
    </message>
    <message>
        <source>Each setting is tried in a small picture of this view…</source>
        <translation>このビューの小さな画像で各設定を試しています…</translation>
    </message>
    <message>
        <source>What evaluate would cost and lose in this view, beside the proven max_gradient.</source>
        <translation>このビューで evaluate にかかるコストと失うものを、証明済みの max_gradient と並べて示します。</translation>
    </message>
    <message>
        <source>Measured before the last change of scene or view.</source>
        <translation>シーンやビューの最後の変更より前の測定です。</translation>
    </message>
    <message>
        <source>evaluate does not pay in this view.</source>
        <translation>このビューでは evaluate は得になりません。</translation>
    </message>
    <message>
        <source>evaluate saves %1 % of the evaluations in this view.</source>
        <translation>このビューでは evaluate で評価が %1 % 減ります。</translation>
    </message>
    <message>
        <source>No max_gradient is proven to be enough; this evaluate loses nothing in this view.</source>
        <translation>十分と証明された max_gradient はありません。この evaluate はこのビューで何も失いません。</translation>
    </message>
</context>
<context>
    <name>isoscope::ExampleMenu</name>
    <message>
        <source>Open the example %1</source>
        <translation>例 %1 を開く</translation>
    </message>
</context>
<context>
    <name>isoscope::ExportController</name>
    <message>
        <source>The text shows no object to write.</source>
        <translation>テキストに書き出すオブジェクトがありません。</translation>
    </message>
    <message>
        <source>The images of height fields can only be written to files.</source>
        <translation>ハイトフィールドの画像はファイルにしか書けません。</translation>
    </message>
    <message>
        <source>The scene has no isosurface to write.</source>
        <translation>シーンに書き出す等値面がありません。</translation>
    </message>
    <message>
        <source>The isosurface is on the clipboard.</source>
        <translation>等値面をクリップボードに入れました。</translation>
    </message>
    <message>
        <source>Write the objects</source>
        <translation>オブジェクトを書き出す</translation>
    </message>
    <message>
        <source>Write the isosurface</source>
        <translation>等値面を書き出す</translation>
    </message>
    <message>
        <source>Write a scene for POV-Ray</source>
        <translation>POV-Ray 用のシーンを書き出す</translation>
    </message>
    <message>
        <source>There is no scene to write yet.</source>
        <translation>書き出すシーンはまだありません。</translation>
    </message>
    <message>
        <source>Write the objects for VirtuaLight</source>
        <translation>VirtuaLight 用にオブジェクトを書き出す</translation>
    </message>
    <message>
        <source>VirtuaLight files (*%1);;All files (*)</source>
        <translation>VirtuaLight ファイル (*%1);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>POV-Ray files (*%1);;All files (*)</source>
        <translation>POV-Ray ファイル (*%1);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>%1 is the scene itself; an export needs a name of its own.</source>
        <translation>%1 はシーン自体です。書き出しには別の名前が必要です。</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>書き込みました: %1</translation>
    </message>
    <message>
        <source>No export of Isoscope made %1.</source>
        <translation>%1 は Isoscope の書き出しではありません。</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>置き換え</translation>
    </message>
    <message>
        <source>What stands in the file now is lost</source>
        <translation>ファイルの今の内容は失われます</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>残す</translation>
    </message>
    <message>
        <source>Write nothing</source>
        <translation>何も書かない</translation>
    </message>
    <message>
        <source>There is no picture to export yet.</source>
        <translation>書き出す画像はまだありません。</translation>
    </message>
    <message>
        <source>There is no text that POV-Ray could draw.</source>
        <translation>POV-Ray が描けるテキストがありません。</translation>
    </message>
    <message>
        <source>POV-Ray reads its own language only; File ▸ Export writes it.</source>
        <translation>POV-Ray は自身の言語だけを読みます。ファイル ▸ 書き出し で書けます。</translation>
    </message>
    <message>
        <source>Not given to POV-Ray: %1.</source>
        <translation>POV-Ray に渡していません: %1。</translation>
    </message>
    <message>
        <source>There is no picture to copy yet.</source>
        <translation>コピーする画像はまだありません。</translation>
    </message>
    <message>
        <source>The picture is on the clipboard.</source>
        <translation>画像をクリップボードに入れました。</translation>
    </message>
    <message>
        <source>The text has errors, or there is none.</source>
        <translation>テキストに誤りがあるか、テキストがありません。</translation>
    </message>
    <message>
        <source>There is no timeline to write. The panel “Timeline” makes one.</source>
        <translation>書き出すタイムラインがありません。パネル「タイムライン」で作れます。</translation>
    </message>
    <message>
        <source>Write an animation for POV-Ray</source>
        <translation>POV-Ray 用のアニメーションを書き出す</translation>
    </message>
    <message>
        <source>%1 is no export of Isoscope; choose another name.</source>
        <translation>%1 は Isoscope の書き出しではありません。別の名前を選んでください。</translation>
    </message>
    <message>
        <source>There is no isosurface to export.</source>
        <translation>書き出す等値面がありません。</translation>
    </message>
    <message>
        <source>There is no view to write yet.</source>
        <translation>書くビューはまだありません。</translation>
    </message>
    <message>
        <source>A camera can only be written into a text for POV-Ray.</source>
        <translation>カメラは POV-Ray 用のテキストにしか書けません。</translation>
    </message>
    <message>
        <source>The camera stands in an include file, which is not changed.</source>
        <translation>カメラはインクルードファイルにあり、変更しません。</translation>
    </message>
    <message>
        <source>The view is the camera of the text now.</source>
        <translation>ビューをテキストのカメラにしました。</translation>
    </message>
    <message>
        <source>No bound is proven (so far): there is no comment of it.</source>
        <translation>上界は(まだ)証明されていないため、コメントはありません。</translation>
    </message>
</context>
<context>
    <name>isoscope::ExternalChanges</name>
    <message>
        <source>See the Difference</source>
        <translation>違いを見る</translation>
    </message>
    <message>
        <source>Show the lines in which the disk and the editor differ</source>
        <translation>ディスクとエディタで異なる行を表示する</translation>
    </message>
    <message>
        <source>Another program changed %1.</source>
        <translation>別のプログラムが %1 を変更しました。</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>再読み込み</translation>
    </message>
    <message>
        <source>Show what stands on the disk now</source>
        <translation>ディスクの今の内容を表示する</translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation>無視</translation>
    </message>
    <message>
        <source>Go on with the text as it is here; saving asks again</source>
        <translation>ここのテキストのまま続ける。保存時に再び尋ねます</translation>
    </message>
    <message>
        <source>Not saved: another program changed %1 meanwhile.</source>
        <translation>保存していません: その間に別のプログラムが %1 を変更しました。</translation>
    </message>
    <message>
        <source>Another program changed %1, and so did you.</source>
        <translation>別のプログラムもあなたも %1 を変更しました。</translation>
    </message>
    <message>
        <source>Take Theirs</source>
        <translation>相手を採用</translation>
    </message>
    <message>
        <source>Show what stands on the disk now; Undo brings your text back</source>
        <translation>ディスクの今の内容を表示する。元に戻すと自分のテキストに戻ります</translation>
    </message>
    <message>
        <source>Save Mine</source>
        <translation>自分のを保存</translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation>自分を維持</translation>
    </message>
    <message>
        <source>Replace the file by the text of the editor</source>
        <translation>ファイルをエディタのテキストで置き換える</translation>
    </message>
    <message>
        <source>Go on with your text; saving replaces the file</source>
        <translation>自分のテキストで続ける。保存するとファイルを置き換えます</translation>
    </message>
    <message>
        <source>Not Now</source>
        <translation>今はしない</translation>
    </message>
    <message>
        <source>Change nothing, neither here nor on the disk</source>
        <translation>ここもディスクも何も変えない</translation>
    </message>
    <message>
        <source>Not saved: %1 is no longer there.</source>
        <translation>保存していません: %1 はもうありません。</translation>
    </message>
    <message>
        <source>%1 is no longer there; its text stands only here.</source>
        <translation>%1 はもうありません。テキストはここだけにあります。</translation>
    </message>
    <message>
        <source>Write It Again</source>
        <translation>再び書く</translation>
    </message>
    <message>
        <source>Save the text under its old name</source>
        <translation>元の名前でテキストを保存する</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>名前を付けて保存…</translation>
    </message>
    <message>
        <source>Save the text under another name</source>
        <translation>テキストを別の名前で保存する</translation>
    </message>
    <message>
        <source>Leave the file away; the text counts as unsaved</source>
        <translation>ファイルを作らない。テキストは未保存の扱いです</translation>
    </message>
</context>
<context>
    <name>isoscope::FileWriter</name>
    <message>
        <source>The text writes to files beside the scene: %1</source>
        <translation>テキストはシーンの隣にファイルを書きます: %1</translation>
    </message>
    <message>
        <source>Allow</source>
        <translation>許可</translation>
    </message>
    <message>
        <source>Write these files now, and again when they change, until the text is closed</source>
        <translation>今、そしてテキストを閉じるまで変更のたびにこれらのファイルを書く</translation>
    </message>
    <message>
        <source>The text would replace %1, which this scene did not write.</source>
        <translation>テキストは、このシーンが書いたのではない %1 を置き換えようとしています。</translation>
    </message>
    <message>
        <source>Replace %1</source>
        <translation>%1 を置き換え</translation>
    </message>
    <message>
        <source>What stands in the file now is lost</source>
        <translation>ファイルの今の内容は失われます</translation>
    </message>
    <message>
        <source>The text adds to %1, each time it is read.</source>
        <translation>テキストは読まれるたびに %1 に書き足します。</translation>
    </message>
    <message>
        <source>Add Once</source>
        <translation>1 回追記</translation>
    </message>
    <message>
        <source>Write to the file once more</source>
        <translation>ファイルにもう 1 回書く</translation>
    </message>
    <message>
        <source>The text writes %1. Save the scene first: files are written beside it only.</source>
        <translation>テキストは %1 を書きます。先にシーンを保存してください。ファイルはその隣にだけ書かれます。</translation>
    </message>
    <message>
        <source>Not Now</source>
        <translation>今はしない</translation>
    </message>
    <message>
        <source>Write nothing; #read and #include of the same text find it all the same</source>
        <translation>何も書かない。同じテキストの #read と #include は見つけられます</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>書き込みました: %1</translation>
    </message>
    <message>
        <source>Not written: %1 (%2)</source>
        <translation>書いていません: %1 (%2)</translation>
    </message>
</context>
<context>
    <name>isoscope::FindBar</name>
    <message>
        <source>Find and replace</source>
        <translation>検索と置換</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>検索</translation>
    </message>
    <message>
        <source>What to look for. Enter: next, Shift+Enter: previous</source>
        <translation>検索する語。Enter: 次、Shift+Enter: 前</translation>
    </message>
    <message>
        <source>Upper and lower case differ</source>
        <translation>大文字と小文字を区別する</translation>
    </message>
    <message>
        <source>Match case</source>
        <translation>大小区別</translation>
    </message>
    <message>
        <source>Whole words only</source>
        <translation>単語全体のみ</translation>
    </message>
    <message>
        <source>Whole words</source>
        <translation>単語全体</translation>
    </message>
    <message>
        <source>Regular expression; \1 in the replacement is the first group</source>
        <translation>正規表現。置換の \1 は最初のグループ</translation>
    </message>
    <message>
        <source>Regular expression</source>
        <translation>正規表現</translation>
    </message>
    <message>
        <source>Number of matches</source>
        <translation>一致の数</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Previous match (Shift+F3)</source>
        <translation>前の一致 (Shift+F3)</translation>
    </message>
    <message>
        <source>Previous match</source>
        <translation>前の一致</translation>
    </message>
    <message>
        <source>Next match (F3)</source>
        <translation>次の一致 (F3)</translation>
    </message>
    <message>
        <source>Next match</source>
        <translation>次の一致</translation>
    </message>
    <message>
        <source>Close (Escape)</source>
        <translation>閉じる (Escape)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Replace with</source>
        <translation>置換後</translation>
    </message>
    <message>
        <source>What to put in its place. Enter replaces the match</source>
        <translation>置き換える文字列。Enter で一致を置換</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>置き換え</translation>
    </message>
    <message>
        <source>Replaces the selected match and goes to the next</source>
        <translation>選択中の一致を置換して次へ移る</translation>
    </message>
    <message>
        <source>Replace all</source>
        <translation>すべて置換</translation>
    </message>
    <message>
        <source>Replaces every match; one undo brings them back</source>
        <translation>すべての一致を置換する。1 回の「元に戻す」で戻ります</translation>
    </message>
    <message>
        <source>Invalid</source>
        <translation>無効</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>%1 found</source>
        <translation>%1 件</translation>
    </message>
    <message>
        <source>Matches in the text</source>
        <translation>テキスト内の一致</translation>
    </message>
    <message>
        <source>The regular expression is not valid: %1</source>
        <translation>正規表現が正しくありません: %1</translation>
    </message>
    <message>
        <source>%1 replaced</source>
        <translation>%1 件置換</translation>
    </message>
    <message>
        <source>expression is too complex</source>
        <translation>式が複雑すぎます</translation>
    </message>
</context>
<context>
    <name>isoscope::FormulaOffer</name>
    <message>
        <source>Make It an Isosurface</source>
        <translation>等値面にする</translation>
    </message>
    <message>
        <source>A formula shows nothing by itself. As an isosurface it can be seen.</source>
        <translation>式だけでは何も表示されません。等値面にすると見えます。</translation>
    </message>
    <message>
        <source>Replace the formula by its isosurface; Undo brings it back</source>
        <translation>式をその等値面に置き換える。元に戻すと式に戻ります</translation>
    </message>
    <message>
        <source>Not Now</source>
        <translation>今はしない</translation>
    </message>
    <message>
        <source>Leave the text as it is</source>
        <translation>テキストをそのままにする</translation>
    </message>
</context>
<context>
    <name>isoscope::FormulaPanel</name>
    <message>
        <source>no infinite slope</source>
        <translation>無限の傾きなし</translation>
    </message>
    <message>
        <source>no overflow</source>
        <translation>オーバーフローなし</translation>
    </message>
    <message>
        <source>%1 times as exact</source>
        <translation>%1 倍正確</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>正確</translation>
    </message>
    <message>
        <source>%1 % less time</source>
        <translation>時間 %1 % 減</translation>
    </message>
    <message>
        <source>no seam</source>
        <translation>継ぎ目なし</translation>
    </message>
    <message>
        <source>the same operations</source>
        <translation>同じ演算</translation>
    </message>
    <message>
        <source>proven</source>
        <translation>証明</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>測定</translation>
    </message>
    <message>
        <source>The isosurface whose function is written otherwise.</source>
        <translation>関数を別の形で書く等値面。</translation>
    </message>
    <message>
        <source>What the chosen rewrite does, and how sure that is</source>
        <translation>選んだ書き換えの内容とその確かさ</translation>
    </message>
    <message>
        <source>Progress of the search for rewrites</source>
        <translation>書き換えの探索の進み具合</translation>
    </message>
    <message>
        <source>How much of the search is done</source>
        <translation>探索がどこまで進んだか</translation>
    </message>
    <message>
        <source>Search or stop</source>
        <translation>探索または停止</translation>
    </message>
    <message>
        <source>Could be written as</source>
        <translation>別の書き方</translation>
    </message>
    <message>
        <source>Gain in POV-Ray</source>
        <translation>POV-Ray での利得</translation>
    </message>
    <message>
        <source>Certainty</source>
        <translation>確かさ</translation>
    </message>
    <message>
        <source>Other ways to write the function</source>
        <translation>関数の別の書き方</translation>
    </message>
    <message>
        <source>Choose one to read what it does; Enter or a double click writes it</source>
        <translation>選ぶとその内容が読めます。Enter かダブルクリックでテキストに書きます</translation>
    </message>
    <message>
        <source>Rewrite</source>
        <translation>書き換える</translation>
    </message>
    <message>
        <source>Changes the text so; Undo takes it back.</source>
        <translation>テキストをこのように変えます。元に戻すで取り消せます。</translation>
    </message>
    <message>
        <source>Write the chosen rewrite into the text</source>
        <translation>選んだ書き換えをテキストに書く</translation>
    </message>
    <message>
        <source>Derivatives as POV-Ray&apos;s text</source>
        <translation>POV-Ray のテキストとしての導関数</translation>
    </message>
    <message>
        <source>The derivatives in x, y and z, the length of the gradient, and a function with the same surface whose gradient is 1 on it</source>
        <translation>x、y、z についての導関数、勾配の長さ、および同じ曲面を持ち、その上で勾配が 1 になる関数</translation>
    </message>
    <message>
        <source>Copy Derivatives</source>
        <translation>導関数をコピー</translation>
    </message>
    <message>
        <source>Puts the declarations on the clipboard.</source>
        <translation>宣言をクリップボードにコピーします。</translation>
    </message>
    <message>
        <source>The derivatives are on the clipboard.</source>
        <translation>導関数をクリップボードにコピーしました。</translation>
    </message>
    <message>
        <source>Insert Derivatives</source>
        <translation>導関数を挿入</translation>
    </message>
    <message>
        <source>Writes the declarations in front of the isosurface; Undo takes it back.</source>
        <translation>宣言を等値面の前に書きます。元に戻すで取り消せます。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>探索</translation>
    </message>
    <message>
        <source>End the search</source>
        <translation>探索を終える</translation>
    </message>
    <message>
        <source>Look for other ways to write the function</source>
        <translation>関数の別の書き方を探す</translation>
    </message>
    <message>
        <source>The scene has no isosurface.</source>
        <translation>シーンに等値面がありません。</translation>
    </message>
    <message>
        <source>Being found out…</source>
        <translation>調べています…</translation>
    </message>
    <message>
        <source>It is found out once nothing moves.</source>
        <translation>何も動かなくなると調べます。</translation>
    </message>
    <message>
        <source>There is no rewrite that pays.</source>
        <translation>得になる書き換えはありません。</translation>
    </message>
    <message>
        <source>Choose a rewrite to read what it does, and how sure that is.</source>
        <translation>書き換えを選ぶと、その内容と確かさが読めます。</translation>
    </message>
</context>
<context>
    <name>isoscope::FrameWriter</name>
    <message>
        <source>Frame %1: %2</source>
        <translation>フレーム %1: %2</translation>
    </message>
</context>
<context>
    <name>isoscope::FunctionBrowser</name>
    <message>
        <source>Parameter</source>
        <translation>パラメータ</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>既定</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>範囲</translation>
    </message>
    <message>
        <source>&lt;tr&gt;&lt;td&gt;%1&amp;nbsp;&amp;nbsp;&lt;/td&gt;&lt;td&gt;%2&amp;nbsp;&amp;nbsp;&lt;/td&gt;&lt;td&gt;%3 to %4&lt;/td&gt;&lt;/tr&gt;</source>
        <translation>&lt;tr&gt;&lt;td&gt;%1&amp;nbsp;&amp;nbsp;&lt;/td&gt;&lt;td&gt;%2&amp;nbsp;&amp;nbsp;&lt;/td&gt;&lt;td&gt;%3～%4&lt;/td&gt;&lt;/tr&gt;</translation>
    </message>
    <message>
        <source>Functions</source>
        <translation>関数</translation>
    </message>
    <message>
        <source>Search functions</source>
        <translation>関数を検索</translation>
    </message>
    <message>
        <source>Words of the name or of parameters. Down goes to the list, Enter inserts</source>
        <translation>名前やパラメータの単語。下キーで一覧へ、Enter で挿入</translation>
    </message>
    <message>
        <source>Double-click or Enter inserts an isosurface of the function</source>
        <translation>ダブルクリックか Enter で関数の等値面を挿入</translation>
    </message>
    <message>
        <source>No function matches the search.</source>
        <translation>検索に合う関数がありません。</translation>
    </message>
    <message>
        <source>About the function</source>
        <translation>関数について</translation>
    </message>
    <message>
        <source>Formula and parameters of the selected function</source>
        <translation>選択した関数の式とパラメータ</translation>
    </message>
    <message>
        <source>Insert isosurface</source>
        <translation>等値面を挿入</translation>
    </message>
    <message>
        <source>Writes a whole isosurface that shows the function, beside what is there (Enter)</source>
        <translation>関数を表示する等値面全体を、今あるものの隣に書く (Enter)</translation>
    </message>
    <message>
        <source>Insert call</source>
        <translation>呼び出しを挿入</translation>
    </message>
    <message>
        <source>Writes just the call at the caret (Shift+Enter)</source>
        <translation>カーソル位置に呼び出しだけを書く (Shift+Enter)</translation>
    </message>
</context>
<context>
    <name>isoscope::GalleryController</name>
    <message>
        <source>Two shapes with a blend between them, and what each number does.</source>
        <translation>2 つの形とその間のブレンド、各数値のはたらき。</translation>
    </message>
    <message>
        <source>What a wrong max_gradient does to POV-Ray&apos;s picture.</source>
        <translation>誤った max_gradient が POV-Ray の画像にすること。</translation>
    </message>
    <message>
        <source>A box whose cross-section turns with its height.</source>
        <translation>高さとともに断面が回る箱。</translation>
    </message>
    <message>
        <source>The product of two functions melts their surfaces.</source>
        <translation>2 つの関数の積が曲面を溶け合わせる。</translation>
    </message>
    <message>
        <source>A polynomial of the sixth degree.</source>
        <translation>6 次の多項式。</translation>
    </message>
    <message>
        <source>Noise added to a ball makes a stone of it.</source>
        <translation>球にノイズを加えると石になる。</translation>
    </message>
    <message>
        <source>A height for every place, from f_ridged_mf.</source>
        <translation>f_ridged_mf による各地点の高さ。</translation>
    </message>
    <message>
        <source>Sines and cosines that part space into two halves.</source>
        <translation>空間を半分に分けるサインとコサイン。</translation>
    </message>
    <message>
        <source>A surface without inside or outside.</source>
        <translation>内も外もない曲面。</translation>
    </message>
    <message>
        <source>VirtuaLight: union, intersection and the rest.</source>
        <translation>VirtuaLight: 和、積、その他。</translation>
    </message>
    <message>
        <source>VirtuaLight: surfaces that it knows by name.</source>
        <translation>VirtuaLight: 名前で知っている曲面。</translation>
    </message>
    <message>
        <source>VirtuaLight: polynomials by their coefficients.</source>
        <translation>VirtuaLight: 係数で与える多項式。</translation>
    </message>
    <message>
        <source>VirtuaLight: formulas of your own.</source>
        <translation>VirtuaLight: 自分の式。</translation>
    </message>
    <message>
        <source>The text could not be kept in your collection.</source>
        <translation>テキストをコレクションに保存できませんでした。</translation>
    </message>
    <message>
        <source>Added to your collection.</source>
        <translation>コレクションに追加しました。</translation>
    </message>
    <message>
        <source>“%1” could not be removed.</source>
        <translation>「%1」を削除できませんでした。</translation>
    </message>
    <message>
        <source>“%1” is removed from your collection.</source>
        <translation>「%1」をコレクションから削除しました。</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Put it back into your collection</source>
        <translation>コレクションに戻す</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Leave it removed</source>
        <translation>削除したままにする</translation>
    </message>
    <message>
        <source>“%1” could not be renamed.</source>
        <translation>「%1」の名前を変更できませんでした。</translation>
    </message>
    <message>
        <source>Renamed to “%1”.</source>
        <translation>「%1」に名前を変更しました。</translation>
    </message>
</context>
<context>
    <name>isoscope::GalleryModel</name>
    <message>
        <source>Function</source>
        <translation>関数</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>パターン</translation>
    </message>
    <message>
        <source>Example</source>
        <translation>例</translation>
    </message>
    <message>
        <source>POV-Ray</source>
        <translation>POV-Ray</translation>
    </message>
    <message>
        <source>My collection</source>
        <translation>マイコレクション</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>レッスン</translation>
    </message>
</context>
<context>
    <name>isoscope::GalleryPanel</name>
    <message>
        <source>Gallery</source>
        <translation>ギャラリー</translation>
    </message>
    <message>
        <source>Search the gallery</source>
        <translation>ギャラリーを検索</translation>
    </message>
    <message>
        <source>Words of title, sentence or kind. Down goes to the list, Enter opens</source>
        <translation>題名、説明、種類の単語。下キーで一覧へ、Enter で開く</translation>
    </message>
    <message>
        <source>A click or Enter opens the scene</source>
        <translation>クリックか Enter でシーンを開く</translation>
    </message>
    <message>
        <source>Scenes of the gallery</source>
        <translation>ギャラリーのシーン</translation>
    </message>
    <message>
        <source>No scene matches the search.</source>
        <translation>検索に合うシーンがありません。</translation>
    </message>
    <message>
        <source>Add to My Collection</source>
        <translation>マイコレクションに追加</translation>
    </message>
    <message>
        <source>Keep the open text in the gallery</source>
        <translation>開いているテキストをギャラリーに保管する</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>開く(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Insert Isosurface</source>
        <translation>等値面を挿入(&amp;I)</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>名前を変更(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Remove from My Collection</source>
        <translation>マイコレクションから削除(&amp;R)</translation>
    </message>
</context>
<context>
    <name>isoscope::GradientPanel</name>
    <message>
        <source>The isosurface whose gradient is measured.</source>
        <translation>勾配を測る等値面。</translation>
    </message>
    <message>
        <source>On the surface</source>
        <translation>曲面上</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>使う</translation>
    </message>
    <message>
        <source>Writes the suggested max_gradient into the text.</source>
        <translation>提案された max_gradient をテキストに書きます。</translation>
    </message>
    <message>
        <source>Use the suggested max_gradient</source>
        <translation>提案された max_gradient を使う</translation>
    </message>
    <message>
        <source>Writes the value that is enough for this view into the text.</source>
        <translation>このビューに足りる値をテキストに書きます。</translation>
    </message>
    <message>
        <source>Use the max_gradient that is enough for this view</source>
        <translation>このビューに足りる max_gradient を使う</translation>
    </message>
    <message>
        <source>Go There</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Shows the steepest place of the function in the picture.</source>
        <translation>関数の最も急な場所を画像に示します。</translation>
    </message>
    <message>
        <source>Show the steepest place in the picture</source>
        <translation>最も急な場所を画像に示す</translation>
    </message>
    <message>
        <source>max_gradient</source>
        <translation>max_gradient</translation>
    </message>
    <message>
        <source>How steep POV-Ray takes the function to be: the number in the text, and what it is worth. Where the function is steeper, POV-Ray steps over the surface, which leaves holes.</source>
        <translation>POV-Ray が見なす関数の傾き: テキストの数値とその評価。関数がこれより急な所では POV-Ray が曲面を飛び越え、穴が残ります。</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>穴</translation>
    </message>
    <message>
        <source>Pixels of this view that POV-Ray&apos;s picture gets wrong with the present setting: lost, gained, or found at a wrong place.</source>
        <translation>現在の設定で POV-Ray の画像が誤るこのビューのピクセル: 消失、余分、位置違い。</translation>
    </message>
    <message>
        <source>Along rays</source>
        <translation>レイに沿って</translation>
    </message>
    <message>
        <source>How steep the function is along the rays of this view: the steepest slope that POV-Ray meets, and reports.</source>
        <translation>このビューのレイに沿った関数の傾き: POV-Ray が出会って報告する最も急な傾き。</translation>
    </message>
    <message>
        <source>How steep the function is where you see the surface: the largest gradient at its visible points.</source>
        <translation>見えている曲面での関数の傾き: 見える点での最大の勾配。</translation>
    </message>
    <message>
        <source>Proven</source>
        <translation>証明済み</translation>
    </message>
    <message>
        <source>How steep the function gets anywhere in its container. The largest gradient lies between these: the first is reached at the place shown, the second nowhere exceeded.</source>
        <translation>コンテナ内での関数の最大の傾き。最大の勾配はこの 2 つの間です。前者は示された場所で達し、後者はどこでも超えません。</translation>
    </message>
    <message>
        <source>Suggested</source>
        <translation>提案</translation>
    </message>
    <message>
        <source>What to write for a picture without holes from every side: the smallest round value that no gradient in the container exceeds.</source>
        <translation>どの側からも穴のない画像のための値: コンテナ内のどの勾配も超えない最小の切りのよい値。</translation>
    </message>
    <message>
        <source>This view</source>
        <translation>このビュー</translation>
    </message>
    <message>
        <source>What is enough for the present view, and faster: the smallest value that loses no pixel of it. Nothing is proven for other views.</source>
        <translation>現在のビューに足り、より速い値: ピクセルを 1 つも失わない最小の値。ほかのビューについては証明していません。</translation>
    </message>
    <message>
        <source>What to do about an infinite gradient</source>
        <translation>無限の勾配への対処</translation>
    </message>
    <message>
        <source>none in %1 pixels</source>
        <translation>%1 ピクセル中なし</translation>
    </message>
    <message>
        <source>%1 lost, %2 gained, %3 at a wrong place, of %4 pixels</source>
        <translation>消失 %1、余分 %2、位置違い %3、全 %4 ピクセル</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%2 で %1</translation>
    </message>
    <message>
        <source>%1: enough for this view, not proven for others</source>
        <translation>%1: このビューには足りる、ほかは未証明</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>, tightening</source>
        <translation>、絞り込み中</translation>
    </message>
    <message>
        <source>, budget spent</source>
        <translation>、予算切れ</translation>
    </message>
    <message>
        <source>unbounded: %1 at %2</source>
        <translation>上界なし: %2 で %1</translation>
    </message>
    <message>
        <source>%1 to %2%3, the first at %4</source>
        <translation>%1～%2%3、前者は %4</translation>
    </message>
    <message>
        <source>%1: enough but for jumps</source>
        <translation>%1: 跳びを除けば足りる</translation>
    </message>
    <message>
        <source>%1: proven for every view</source>
        <translation>%1: すべてのビューで証明済み</translation>
    </message>
    <message>
        <source>at most %1 so far</source>
        <translation>現在のところ最大 %1</translation>
    </message>
    <message>
        <source>The scene has no isosurface to measure.</source>
        <translation>測定する等値面がシーンにありません。</translation>
    </message>
    <message>
        <source>No bound at %1: %2. %3</source>
        <translation>%1 に上界なし: %2。%3</translation>
    </message>
    <message>
        <source>Farther than %1 from such places no gradient exceeds %2.</source>
        <translation>そのような場所から %1 より離れれば、勾配は %2 を超えません。</translation>
    </message>
    <message>
        <source>Beside jumps no gradient exceeds %1.</source>
        <translation>跳びを除けば、勾配は %1 を超えません。</translation>
    </message>
    <message>
        <source>The bound holds beside places where the function may jump; none was found.</source>
        <translation>上界は関数が跳びうる場所を除いて成り立ちます。そのような場所は見つかっていません。</translation>
    </message>
    <message>
        <source>At the mouse</source>
        <translation>マウス位置</translation>
    </message>
    <message>
        <source>How steep the function is at the point under the mouse, in the picture, the cross-section or a chart, beside max_gradient.</source>
        <translation>画像、断面、グラフのマウス位置の点での関数の傾きを、max_gradient と並べて示します。</translation>
    </message>
    <message>
        <source>f is undefined</source>
        <translation>f は未定義</translation>
    </message>
    <message>
        <source>infinite</source>
        <translation>無限</translation>
    </message>
    <message>
        <source>%1: %2 % of max_gradient</source>
        <translation>%1: max_gradient の %2 %</translation>
    </message>
</context>
<context>
    <name>isoscope::HelpBrowser</name>
    <message>
        <source>Page of the help</source>
        <translation>ヘルプのページ</translation>
    </message>
</context>
<context>
    <name>isoscope::HelpController</name>
    <message>
        <source>Help</source>
        <translation>ヘルプ</translation>
    </message>
    <message>
        <source>&lt;p&gt;Lessons, and pages about the language, the functions and the window. F1 opens the one about what has the focus.&lt;/p&gt;</source>
        <translation>&lt;p&gt;レッスンと、言語・関数・ウィンドウについてのページ。F1 でフォーカスのあるもののページを開きます。&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>isoscope::HelpPanel</name>
    <message>
        <source>Help</source>
        <translation>ヘルプ</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>戻る</translation>
    </message>
    <message>
        <source>To the page before (Alt+Left)</source>
        <translation>前のページへ (Alt+左)</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>進む</translation>
    </message>
    <message>
        <source>To the next page (Alt+Right)</source>
        <translation>次のページへ (Alt+右)</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>目次</translation>
    </message>
    <message>
        <source>The list of all pages</source>
        <translation>全ページの一覧</translation>
    </message>
    <message>
        <source>Search the help</source>
        <translation>ヘルプを検索</translation>
    </message>
    <message>
        <source>Words that stand on a page. Down goes to the list, Enter opens</source>
        <translation>ページにある単語。下キーで一覧へ、Enter で開く</translation>
    </message>
    <message>
        <source>Pages of the help</source>
        <translation>ヘルプのページ</translation>
    </message>
    <message>
        <source>A click or Enter opens the page</source>
        <translation>クリックか Enter でページを開く</translation>
    </message>
    <message>
        <source>No page has all these words.</source>
        <translation>これらの単語をすべて含むページはありません。</translation>
    </message>
    <message>
        <source>Find on this page</source>
        <translation>このページ内を検索</translation>
    </message>
    <message>
        <source>Enter goes to the next place, Shift+Enter to the one before</source>
        <translation>Enter で次の場所へ、Shift+Enter で前の場所へ</translation>
    </message>
    <message>
        <source>Number of places</source>
        <translation>場所の数</translation>
    </message>
    <message>
        <source>Find previous</source>
        <translation>前を検索</translation>
    </message>
    <message>
        <source>To the place before</source>
        <translation>前の場所へ</translation>
    </message>
    <message>
        <source>Find next</source>
        <translation>次を検索</translation>
    </message>
    <message>
        <source>To the next place</source>
        <translation>次の場所へ</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s)</source>
        <translation>
            <numerusform>%n か所</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>isoscope::HistogramPanel</name>
    <message>
        <source>Histogram of the gradient</source>
        <translation>勾配のヒストグラム</translation>
    </message>
    <message>
        <source>How steep the function is, and how often: how much of the container, and of the surface, has which gradient |∇f|.</source>
        <translation>関数の傾きとその頻度: コンテナと曲面のどれだけがどの勾配 |∇f| を持つか。</translation>
    </message>
    <message>
        <source>How much is steeper than max_gradient</source>
        <translation>max_gradient より急な割合</translation>
    </message>
    <message>
        <source>gradient</source>
        <translation>勾配</translation>
    </message>
    <message>
        <source>The gradient of the isosurface is shown here once it is measured.</source>
        <translation>等値面の勾配は、測定が済むとここに表示されます。</translation>
    </message>
    <message>
        <source>in the container</source>
        <translation>コンテナ内</translation>
    </message>
    <message>
        <source>on the surface</source>
        <translation>曲面上</translation>
    </message>
    <message>
        <source>max_gradient %1</source>
        <translation>max_gradient %1</translation>
    </message>
    <message>
        <source>attained %1</source>
        <translation>到達 %1</translation>
    </message>
    <message>
        <source>proven %1</source>
        <translation>証明 %1</translation>
    </message>
    <message>
        <source>0 to %1: %2</source>
        <translation>0～%1: %2</translation>
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
        <translation>勾配の分布</translation>
    </message>
    <message>
        <source>Steeper than max_gradient: %1 of the container, %2 of the surface.</source>
        <translation>max_gradient より急: コンテナの %1、曲面の %2。</translation>
    </message>
    <message>
        <source>Steeper than max_gradient: %1 of the container. No surface was met.</source>
        <translation>max_gradient より急: コンテナの %1。曲面はありませんでした。</translation>
    </message>
    <message>
        <source> Infinite at %1 samples.</source>
        <translation> %1 サンプルで無限。</translation>
    </message>
</context>
<context>
    <name>isoscope::ImageExportDialog</name>
    <message>
        <source>Export image</source>
        <translation>画像の書き出し</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>進み具合</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>Width of the image</source>
        <translation>画像の幅</translation>
    </message>
    <message>
        <source>Height of the image</source>
        <translation>画像の高さ</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大きさ</translation>
    </message>
    <message>
        <source>Keep the proportions</source>
        <translation>縦横比を保つ</translation>
    </message>
    <message>
        <source>Width and height follow each other, so that the picture shows what the window shows</source>
        <translation>画像がウィンドウと同じものを写すように、幅と高さを連動させる</translation>
    </message>
    <message>
        <source>Smooth edges (anti-aliasing)</source>
        <translation>なめらかな縁 (アンチエイリアス)</translation>
    </message>
    <message>
        <source>Several rays for pixels on edges; takes longer</source>
        <translation>縁のピクセルに複数のレイを使う。時間がかかります</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>透明な背景</translation>
    </message>
    <message>
        <source>Leave out background and sky where no object hides them; the file says how much shows through</source>
        <translation>オブジェクトに隠れない背景と空を省く。透け具合はファイルに記録されます</translation>
    </message>
    <message>
        <source>The file to write: .png for an image, .exr for OpenEXR with layers</source>
        <translation>書き込むファイル: .png は画像、.exr はレイヤー付き OpenEXR</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>選ぶ…</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>ファイルを選ぶ</translation>
    </message>
    <message>
        <source>PNG, 8 bits a channel</source>
        <translation>PNG、8 ビット/チャンネル</translation>
    </message>
    <message>
        <source>PNG, 16 bits a channel</source>
        <translation>PNG、16 ビット/チャンネル</translation>
    </message>
    <message>
        <source>16 bits keep steps of light that 8 bits round away, in files of twice the size</source>
        <translation>8 ビットでは丸められる光の段階を 16 ビットは保ちます。ファイルは 2 倍の大きさ</translation>
    </message>
    <message>
        <source>OpenEXR: colour, opacity, distance, normals, verdicts</source>
        <translation>OpenEXR: 色、不透明度、距離、法線、判定</translation>
    </message>
    <message>
        <source>Channels R, G, B, A; Z; N.X, N.Y, N.Z; verdict, with the exact root finder</source>
        <translation>チャンネル R, G, B, A; Z; N.X, N.Y, N.Z; 判定 (正確な求根法のとき)</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>Render</source>
        <translation>計算</translation>
    </message>
    <message>
        <source>Render the image and write it</source>
        <translation>画像を計算して書き込む</translation>
    </message>
    <message>
        <source>Queue</source>
        <translation>待ち行列</translation>
    </message>
    <message>
        <source>Render the image behind those that are waiting; it goes on when this is closed</source>
        <translation>待っている画像の後に計算する。これを閉じても続きます</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stop; no file is written</source>
        <translation>停止する。ファイルは書きません</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Close; an export that is waited for is stopped</source>
        <translation>閉じる。待っている書き出しは停止します</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>Open the image in the program for images</source>
        <translation>画像用のプログラムで画像を開く</translation>
    </message>
    <message>
        <source>Show Folder</source>
        <translation>フォルダを表示</translation>
    </message>
    <message>
        <source>Open the folder that holds the image</source>
        <translation>画像のあるフォルダを開く</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>置き換え</translation>
    </message>
    <message>
        <source>%1 exists already. Replace it?</source>
        <translation>%1 はすでにあります。置き換えますか?</translation>
    </message>
    <message>
        <source>PNG images (*.png)</source>
        <translation>PNG 画像 (*.png)</translation>
    </message>
    <message>
        <source>OpenEXR images (*.exr)</source>
        <translation>OpenEXR 画像 (*.exr)</translation>
    </message>
    <message>
        <source>Please choose a file.</source>
        <translation>ファイルを選んでください。</translation>
    </message>
    <message>
        <source>The file exists and is no PNG or OpenEXR picture: it is not replaced.</source>
        <translation>ファイルは PNG でも OpenEXR でもないため、置き換えません。</translation>
    </message>
    <message>
        <source>%1 is in the queue. Pictures on the way: %2</source>
        <translation>%1 を待ち行列に入れました。計算中の画像: %2</translation>
    </message>
    <message>
        <source>Waits for other pictures…</source>
        <translation>ほかの画像を待っています…</translation>
    </message>
    <message>
        <source>Rendering…</source>
        <translation>計算中…</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>書き込みました: %1</translation>
    </message>
    <message>
        <source>How long the picture will take with all cores of this computer: squares of it are drawn to find out. POV-Ray&apos;s time follows from the function and what its method evaluates.</source>
        <translation>このコンピューターの全コアで画像にかかる時間。画像の一部の正方形を描いて調べます。POV-Ray の時間は、関数とその方法の評価回数から求めます。</translation>
    </message>
    <message>
        <source>How long the picture will take</source>
        <translation>画像にかかる時間</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時間</translation>
    </message>
</context>
<context>
    <name>isoscope::IncludeFoldersDialog</name>
    <message>
        <source>Include folders</source>
        <translation>インクルードフォルダ</translation>
    </message>
    <message>
        <source>#include looks beside the scene first, then in these folders, from the top, then in those of an installed POV-Ray.</source>
        <translation>#include はまずシーンの隣、次にこれらのフォルダを上から順に、最後にインストール済みの POV-Ray のフォルダを探します。</translation>
    </message>
    <message>
        <source>Folders in the order in which they are searched; drag to change it</source>
        <translation>探す順のフォルダ。ドラッグで順序を変更</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>追加…</translation>
    </message>
    <message>
        <source>Add a folder</source>
        <translation>フォルダを追加する</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Remove the selected folder from the list</source>
        <translation>選択したフォルダを一覧から外す</translation>
    </message>
    <message>
        <source>Use these folders</source>
        <translation>これらのフォルダを使う</translation>
    </message>
    <message>
        <source>Leave the folders as they were</source>
        <translation>フォルダを元のままにする</translation>
    </message>
    <message>
        <source>Add an include folder</source>
        <translation>インクルードフォルダを追加</translation>
    </message>
</context>
<context>
    <name>isoscope::IncludeViewer</name>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Close the include file (Esc)</source>
        <translation>インクルードファイルを閉じる (Esc)</translation>
    </message>
    <message>
        <source>Close the include file</source>
        <translation>インクルードファイルを閉じる</translation>
    </message>
    <message>
        <source>Include file, read only</source>
        <translation>インクルードファイル、読み取り専用</translation>
    </message>
    <message>
        <source>%1 – read only</source>
        <translation>%1 – 読み取り専用</translation>
    </message>
</context>
<context>
    <name>isoscope::InsertionController</name>
    <message>
        <source>VirtuaLight&apos;s notation does not know POV-Ray&apos;s functions.</source>
        <translation>VirtuaLight の記法に POV-Ray の関数はありません。</translation>
    </message>
</context>
<context>
    <name>isoscope::KeptTextsWindow</name>
    <message>
        <source>Kept texts</source>
        <translation>保管テキスト</translation>
    </message>
    <message>
        <source>First lines of the text</source>
        <translation>テキストの最初の行</translation>
    </message>
    <message>
        <source>Bring Back</source>
        <translation>戻す</translation>
    </message>
    <message>
        <source>Show this text in the editor</source>
        <translation>このテキストをエディタに表示する</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>破棄</translation>
    </message>
    <message>
        <source>Delete this text for good</source>
        <translation>このテキストを完全に削除する</translation>
    </message>
    <message>
        <source>Discard All</source>
        <translation>すべて破棄</translation>
    </message>
    <message>
        <source>Delete all kept texts for good</source>
        <translation>保管テキストをすべて完全に削除する</translation>
    </message>
    <message>
        <source>Discard All %1 for Good</source>
        <translation>%1 個すべてを完全に破棄</translation>
    </message>
    <message>
        <source>There are no kept texts.</source>
        <translation>保管テキストはありません。</translation>
    </message>
    <message>
        <source>Texts that were never saved. Each stays here until it is saved or discarded, for %1 days at least.</source>
        <translation>一度も保存されなかったテキストです。保存か破棄されるまで、少なくとも %1 日間ここに残ります。</translation>
    </message>
    <message>
        <source>Never had a file</source>
        <translation>ファイルなし</translation>
    </message>
</context>
<context>
    <name>isoscope::LinkedProbe</name>
    <message>
        <source>undefined</source>
        <translation>未定義</translation>
    </message>
    <message>
        <source>infinite</source>
        <translation>無限</translation>
    </message>
    <message>
        <source>x %1, y %2, z %3: %4</source>
        <translation>x %1, y %2, z %3: %4</translation>
    </message>
    <message>
        <source>f is undefined</source>
        <translation>f は未定義</translation>
    </message>
    <message>
        <source>f %1, |∇f| %2</source>
        <translation>f %1, |∇f| %2</translation>
    </message>
    <message>
        <source>%1, distance %2</source>
        <translation>%1, 距離 %2</translation>
    </message>
</context>
<context>
    <name>isoscope::MainWindow</name>
    <message>
        <source>Another window could not be opened.</source>
        <translation>別のウィンドウを開けませんでした。</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>テキスト</translation>
    </message>
    <message>
        <source>&lt;p&gt;The text of the scene, in POV-Ray&apos;s language. The picture follows while you type; signs in the margin tell what is wrong and whether surfaces have holes.&lt;/p&gt;</source>
        <translation>&lt;p&gt;POV-Ray の言語によるシーンのテキスト。入力すると画像が追従します。余白の印は、誤りと、曲面に穴があるかを示します。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>パラメータ</translation>
    </message>
    <message>
        <source>&lt;p&gt;A slider for every number of the text that can be moved. Moving it writes the number.&lt;/p&gt;</source>
        <translation>&lt;p&gt;動かせるテキストの数値ごとのスライダー。動かすと数値が書かれます。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Functions</source>
        <translation>関数</translation>
    </message>
    <message>
        <source>&lt;p&gt;The functions that can be inserted, with pictures.&lt;/p&gt;</source>
        <translation>&lt;p&gt;挿入できる関数、画像付き。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>問題</translation>
    </message>
    <message>
        <source>&lt;p&gt;What is wrong with the text, what is not shown of it, and which isosurfaces have holes in POV-Ray. Click a line to go there; buttons mend what can be mended.&lt;/p&gt;</source>
        <translation>&lt;p&gt;テキストの誤り、表示されない部分、POV-Ray で穴のできる等値面。行をクリックするとそこへ移り、直せるものはボタンで直せます。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Gallery</source>
        <translation>ギャラリー</translation>
    </message>
    <message>
        <source>&lt;p&gt;Functions, examples, POV-Ray&apos;s snippets and your own scenes. A click opens one.&lt;/p&gt;</source>
        <translation>&lt;p&gt;関数、例、POV-Ray のスニペット、自分のシーン。クリックで開きます。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>タイムライン</translation>
    </message>
    <message>
        <source>&lt;p&gt;The frames of an animation, and the keys of numbers and view that make them. All of it is kept in comments of the text.&lt;/p&gt;</source>
        <translation>&lt;p&gt;アニメーションのフレームと、それを作る数値とビューのキー。すべてテキストのコメントに保存されます。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>ツール</translation>
    </message>
    <message>
        <source>Place of the caret in the text</source>
        <translation>テキスト内のカーソルの位置</translation>
    </message>
    <message>
        <source>Place of the caret</source>
        <translation>カーソルの位置</translation>
    </message>
    <message>
        <source>Line %1, column %2</source>
        <translation>%1 行 %2 列</translation>
    </message>
    <message>
        <source>The text is newer than the picture; saving or F5 shows it.</source>
        <translation>テキストは画像より新しい内容です。保存か F5 で表示されます。</translation>
    </message>
    <message>
        <source>The language changes at the next start.</source>
        <translation>言語は次回の起動時に変わります。</translation>
    </message>
    <message>
        <source>%1 – Isoscope</source>
        <translation>%1 – Isoscope</translation>
    </message>
    <message>
        <source>The point under the mouse in the picture, the cross-section or a chart, in the coordinates of its function, with f and its gradient</source>
        <translation>画像、断面、グラフのマウス位置の点を、その関数の座標で、f とその勾配とともに示します</translation>
    </message>
    <message>
        <source>The probed point</source>
        <translation>調べている点</translation>
    </message>
</context>
<context>
    <name>isoscope::MeshExportDialog</name>
    <message>
        <source>Export mesh</source>
        <translation>メッシュの書き出し</translation>
    </message>
    <message>
        <source>The notation of the file; its ending follows</source>
        <translation>ファイルの形式。拡張子も変わります</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>a 500th of the container</source>
        <translation>コンテナの 500 分の 1</translation>
    </message>
    <message>
        <source>How far mesh and surface may be apart, in units of the scene</source>
        <translation>メッシュと曲面の許される隔たり、シーンの単位</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>許容差</translation>
    </message>
    <message>
        <source>Colours of the texture</source>
        <translation>テクスチャの色</translation>
    </message>
    <message>
        <source>A colour for each vertex, where the format has colours</source>
        <translation>形式が色を持つ場合、頂点ごとの色</translation>
    </message>
    <message>
        <source>The file to write</source>
        <translation>書き込むファイル</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>選ぶ…</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>ファイルを選ぶ</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>進み具合</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>書き出し</translation>
    </message>
    <message>
        <source>Make the mesh and write it</source>
        <translation>メッシュを作って書き込む</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stop; no file is written</source>
        <translation>停止する。ファイルは書きません</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Close; a running export is stopped</source>
        <translation>閉じる。実行中の書き出しは停止します</translation>
    </message>
    <message>
        <source>Show Folder</source>
        <translation>フォルダを表示</translation>
    </message>
    <message>
        <source>Open the folder that holds the mesh</source>
        <translation>メッシュのあるフォルダを開く</translation>
    </message>
    <message>
        <source>Meshes (*.stl *.3mf *.obj *.ply *.glb *.inc)</source>
        <translation>メッシュ (*.stl *.3mf *.obj *.ply *.glb *.inc)</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>置き換え</translation>
    </message>
    <message>
        <source>%1 exists already. Replace it?</source>
        <translation>%1 はすでにあります。置き換えますか?</translation>
    </message>
    <message>
        <source>Please choose a file.</source>
        <translation>ファイルを選んでください。</translation>
    </message>
    <message>
        <source>The tolerance is a positive number, or empty.</source>
        <translation>許容差は正の数か、空にします。</translation>
    </message>
    <message>
        <source>The file exists and is no mesh of Isoscope: it is not replaced.</source>
        <translation>ファイルは Isoscope のメッシュではないため、置き換えません。</translation>
    </message>
    <message>
        <source>Looking for the surface…</source>
        <translation>曲面を探しています…</translation>
    </message>
    <message>
        <source>Stopped; nothing was written.</source>
        <translation>停止しました。何も書いていません。</translation>
    </message>
    <message>
        <source>No mesh: %1.</source>
        <translation>メッシュなし: %1。</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>停止中…</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>書き込みました: %1</translation>
    </message>
</context>
<context>
    <name>isoscope::NoticeBar</name>
    <message>
        <source>Notice</source>
        <translation>お知らせ</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Hide this line</source>
        <translation>この行を隠す</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <comment>notices</comment>
        <translation>
            <numerusform>ほか %n 件</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>isoscope::NumberPopup</name>
    <message>
        <source>Slider for the number at the caret</source>
        <translation>カーソル位置の数値のスライダー</translation>
    </message>
    <message>
        <source>Enter keeps the number, Esc brings the first one back</source>
        <translation>Enter で数値を確定、Esc で元の値に戻す</translation>
    </message>
</context>
<context>
    <name>isoscope::NumberTool</name>
    <message>
        <source>Slider for the number at the caret</source>
        <translation>カーソル位置の数値のスライダー</translation>
    </message>
    <message>
        <source>Change this number with a slider</source>
        <translation>この数値をスライダーで変える</translation>
    </message>
    <message>
        <source>There is no number at the caret.</source>
        <translation>カーソル位置に数値がありません。</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>数値</translation>
    </message>
</context>
<context>
    <name>isoscope::OverlayBar</name>
    <message>
        <source>What the overlay shows</source>
        <translation>重ね表示の内容</translation>
    </message>
    <message>
        <source>Counted in the pixels of this picture, with the settings of the text</source>
        <translation>テキストの設定で、この画像のピクセルを数えたもの</translation>
    </message>
    <message>
        <source>Progress of the overlay</source>
        <translation>重ね表示の進み具合</translation>
    </message>
    <message>
        <source>How much of the overlay is computed</source>
        <translation>重ね表示がどこまで計算されたか</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stop computing the overlay</source>
        <translation>重ね表示の計算を停止</translation>
    </message>
</context>
<context>
    <name>isoscope::OverlayButton</name>
    <message>
        <source>What is laid over the picture: holes of POV-Ray&apos;s method, or the gradient</source>
        <translation>画像に重ねるもの: POV-Ray の方法の穴、または勾配</translation>
    </message>
    <message>
        <source>Overlay of the picture</source>
        <translation>画像の重ね表示</translation>
    </message>
</context>
<context>
    <name>isoscope::ParameterBinding</name>
    <message>
        <source>Kept until the file is closed: the text can only keep it for the last number of a line</source>
        <translation>ファイルを閉じるまで有効: テキストには行の最後の数値についてだけ保存できます</translation>
    </message>
</context>
<context>
    <name>isoscope::ParameterGroup</name>
    <message>
        <source>Show or hide the parameters of %1</source>
        <translation>%1 のパラメータを表示または隠す</translation>
    </message>
</context>
<context>
    <name>isoscope::ParameterPanel</name>
    <message>
        <source>Filter parameters</source>
        <translation>パラメータを絞り込む</translation>
    </message>
    <message>
        <source>Shows only parameters whose name or function contains these words</source>
        <translation>名前か関数にこれらの単語を含むパラメータだけを表示する</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>パラメータ</translation>
    </message>
    <message>
        <source>Numbers of the scene. A double click on a name brings its first value back</source>
        <translation>シーンの数値。名前のダブルクリックで最初の値に戻ります</translation>
    </message>
    <message>
        <source>Randomise</source>
        <translation>ランダム</translation>
    </message>
    <message>
        <source>Random values for the numbers listed here; locked ones, containers, accuracy and max_gradient stay</source>
        <translation>ここの数値をランダムな値にする。ロックされたもの、コンテナ、accuracy、max_gradient は変わりません</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>すべて戻す</translation>
    </message>
    <message>
        <source>Brings the first values of the numbers listed here back; locked ones stay</source>
        <translation>ここの数値を最初の値に戻す。ロックされたものは変わりません</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>その他</translation>
    </message>
    <message>
        <source>, lines %1 to %2</source>
        <translation>、%1～%2 行</translation>
    </message>
    <message>
        <source>, line %1</source>
        <translation>、%1 行</translation>
    </message>
    <message>
        <source>Nothing to move yet.
Numbers of function calls, #declare, threshold, accuracy, max_gradient and contained_by appear here.</source>
        <translation>動かせるものはまだありません。
関数の呼び出し、#declare、threshold、accuracy、max_gradient、contained_by の数値がここに現れます。</translation>
    </message>
    <message>
        <source>No parameter matches the filter.</source>
        <translation>絞り込みに合うパラメータはありません。</translation>
    </message>
    <message numerus="yes">
        <source>%n more number(s) are not shown; drag them in the text with Ctrl.</source>
        <translation>
            <numerusform>ほかに %n 個の数値は表示していません。テキスト内で Ctrl を押しながらドラッグしてください。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>isoscope::ParameterSlider</name>
    <message>
        <source>More</source>
        <translation>その他</translation>
    </message>
    <message>
        <source>Replace by number</source>
        <translation>数値に置き換え</translation>
    </message>
    <message>
        <source>%1 (default)</source>
        <translation>%1 (既定)</translation>
    </message>
    <message>
        <source>%1 (x, y and z)</source>
        <translation>%1 (x、y、z)</translation>
    </message>
    <message>
        <source>%1 is the expression %2</source>
        <translation>%1 は式 %2 です</translation>
    </message>
    <message>
        <source>Expression of %1</source>
        <translation>%1 の式</translation>
    </message>
    <message>
        <source>Writes %1 in place of the expression, which gives it a slider</source>
        <translation>式の代わりに %1 を書き、スライダーを使えるようにする</translation>
    </message>
    <message>
        <source>Replace the expression of %1 by a number</source>
        <translation>%1 の式を数値に置き換える</translation>
    </message>
    <message>
        <source>%1 is not in the text; moving the slider writes it</source>
        <translation>%1 はテキストにありません。スライダーを動かすと書かれます</translation>
    </message>
    <message>
        <source>%1. Double-click: back to %2</source>
        <translation>%1。ダブルクリック: %2 に戻す</translation>
    </message>
    <message>
        <source>%1, from %2 to %3</source>
        <translation>%1、%2 から %3 まで</translation>
    </message>
    <message>
        <source>There can be a surface from %1 to %2, the green part; for no other value of the slider, all else as it is</source>
        <translation>ほかがそのままなら、曲面がありうるのは緑の部分の %1～%2 で、スライダーのほかの値ではありません</translation>
    </message>
    <message>
        <source>There is no surface for any value of the slider, all else as it is</source>
        <translation>ほかがそのままなら、スライダーのどの値でも曲面はありません</translation>
    </message>
    <message>
        <source>%1, slider</source>
        <translation>%1、スライダー</translation>
    </message>
    <message>
        <source>Value of %1</source>
        <translation>%1 の値</translation>
    </message>
    <message>
        <source>Lower end of the slider. Double-click to change it</source>
        <translation>スライダーの下端。ダブルクリックで変更</translation>
    </message>
    <message>
        <source>Upper end of the slider. Double-click to change it</source>
        <translation>スライダーの上端。ダブルクリックで変更</translation>
    </message>
    <message>
        <source>Lower end of %1</source>
        <translation>%1 の下端</translation>
    </message>
    <message>
        <source>Upper end of %1</source>
        <translation>%1 の上端</translation>
    </message>
    <message>
        <source>Stop (Esc)</source>
        <translation>停止 (Esc)</translation>
    </message>
    <message>
        <source>Play: moves %1 by itself, until Esc or a touch of the slider</source>
        <translation>再生: Esc かスライダーに触れるまで %1 をひとりでに動かす</translation>
    </message>
    <message>
        <source>Stop %1</source>
        <translation>%1 を停止</translation>
    </message>
    <message>
        <source>Play %1</source>
        <translation>%1 を再生</translation>
    </message>
    <message>
        <source>%1 is locked. Click to move it again</source>
        <translation>%1 はロックされています。クリックで再び動かせます</translation>
    </message>
    <message>
        <source>Unlock %1</source>
        <translation>%1 のロックを解除</translation>
    </message>
    <message>
        <source>Range, step, lock and more of %1</source>
        <translation>%1 の範囲、ステップ、ロックなど</translation>
    </message>
    <message>
        <source>Menu of %1</source>
        <translation>%1 のメニュー</translation>
    </message>
    <message>
        <source>Back to %1</source>
        <translation>%1 に戻す</translation>
    </message>
    <message>
        <source>The value that the text had when it was opened</source>
        <translation>テキストを開いたときの値</translation>
    </message>
    <message>
        <source>Random value</source>
        <translation>ランダムな値</translation>
    </message>
    <message>
        <source>Any value of the slider</source>
        <translation>スライダーの任意の値</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>ロック</translation>
    </message>
    <message>
        <source>The slider does not move, nor does a preset or Randomise move it</source>
        <translation>スライダーは動かず、プリセットやランダムでも動きません</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>Set key at this frame</source>
        <translation>このフレームにキーを置く</translation>
    </message>
    <message>
        <source>The timeline keeps the present value, in a comment of the text</source>
        <translation>タイムラインが現在の値をテキストのコメントに保存します</translation>
    </message>
    <message>
        <source>Range, step and scale…</source>
        <translation>範囲、ステップ、目盛り…</translation>
    </message>
    <message>
        <source>How the slider moves; kept in the text, in a comment behind the number</source>
        <translation>スライダーの動き方。数値の後のコメントとしてテキストに保存</translation>
    </message>
    <message>
        <source>Usual range</source>
        <translation>通常の範囲</translation>
    </message>
    <message>
        <source>Takes the comment about the slider out of the text</source>
        <translation>スライダーのコメントをテキストから取り除く</translation>
    </message>
    <message>
        <source>Enter sets the end, Escape leaves it</source>
        <translation>Enter で端を設定、Escape でそのまま</translation>
    </message>
    <message>
        <source>Back and forth</source>
        <translation>往復</translation>
    </message>
    <message>
        <source>Turns round at each end</source>
        <translation>両端で向きを変える</translation>
    </message>
    <message>
        <source>Round and round</source>
        <translation>繰り返し</translation>
    </message>
    <message>
        <source>Begins at the lower end again</source>
        <translation>下端から再び始める</translation>
    </message>
    <message>
        <source>Once</source>
        <translation>1 回</translation>
    </message>
    <message>
        <source>Stops at the upper end</source>
        <translation>上端で止まる</translation>
    </message>
    <message>
        <source>%1 s from end to end</source>
        <translation>端から端まで %1 秒</translation>
    </message>
    <message>
        <source>How fast it plays</source>
        <translation>再生の速さ</translation>
    </message>
</context>
<context>
    <name>isoscope::PictureForecast</name>
    <message>
        <source>0.1 s or less</source>
        <translation>0.1 秒以下</translation>
    </message>
    <message>
        <source>Being measured…</source>
        <translation>測定しています…</translation>
    </message>
    <message>
        <source>Here about %1 (±%2 %)</source>
        <translation>ここで約 %1 (±%2 %)</translation>
    </message>
    <message>
        <source>, POV-Ray without smooth edges about %1 (±%2 %)</source>
        <translation>, POV-Ray はなめらかな縁なしで約 %1 (±%2 %)</translation>
    </message>
    <message>
        <source>, POV-Ray about %1 (±%2 %)</source>
        <translation>, POV-Ray は約 %1 (±%2 %)</translation>
    </message>
</context>
<context>
    <name>isoscope::PictureQueue</name>
    <message>
        <source>%1 could not be written: %2.</source>
        <translation>%1 に書き込めませんでした: %2。</translation>
    </message>
    <message>
        <source>Stopped; nothing was written.</source>
        <translation>停止しました。何も書いていません。</translation>
    </message>
</context>
<context>
    <name>isoscope::PictureQueueWindow</name>
    <message>
        <source>Pictures in the making</source>
        <translation>計算中の画像</translation>
    </message>
    <message>
        <source>No picture is on the way. File ▸ Export ▸ Image… puts them here by its button “Queue”.</source>
        <translation>計算中の画像はありません。ファイル ▸ 書き出し ▸ 画像… のボタン「待ち行列」でここに入ります。</translation>
    </message>
    <message>
        <source>Stop All</source>
        <translation>すべて停止</translation>
    </message>
    <message>
        <source>Stop every picture that is not written yet</source>
        <translation>まだ書き込まれていない画像をすべて停止する</translation>
    </message>
    <message>
        <source>Clear List</source>
        <translation>一覧を消去</translation>
    </message>
    <message>
        <source>Take the pictures off the list that are written or stopped; files stay</source>
        <translation>書き込み済みや停止した画像を一覧から外す。ファイルは残ります</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Close; pictures go on</source>
        <translation>閉じる。画像の計算は続きます</translation>
    </message>
    <message>
        <source>%1, %2 × %3</source>
        <translation>%1、%2 × %3</translation>
    </message>
    <message>
        <source>Progress of %1</source>
        <translation>%1 の進み具合</translation>
    </message>
    <message>
        <source>Open %1 in the program for images</source>
        <translation>画像用のプログラムで %1 を開く</translation>
    </message>
    <message>
        <source>Stop %1</source>
        <translation>%1 を停止</translation>
    </message>
</context>
<context>
    <name>isoscope::PictureRoom</name>
    <message>
        <source>&amp;Fold the Panels Below</source>
        <translation>下のパネルを折りたたむ(&amp;F)</translation>
    </message>
    <message>
        <source>Leave of the panels below the picture only their tabs; a click on a tab unfolds them</source>
        <translation>画像の下のパネルをタブだけにする。タブのクリックで広がります</translation>
    </message>
    <message>
        <source>Unfold the panels below</source>
        <translation>下のパネルを広げる</translation>
    </message>
    <message>
        <source>Fold the panels below</source>
        <translation>下のパネルを折りたたむ</translation>
    </message>
</context>
<context>
    <name>isoscope::PresetController</name>
    <message>
        <source>Presets</source>
        <translation>プリセット</translation>
    </message>
    <message>
        <source>Presets: named sets of values, kept in the text</source>
        <translation>プリセット: テキストに保存される名前付きの値の組</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>プリセットの名前</translation>
    </message>
    <message>
        <source>Enter keeps the preset under this name, Esc leaves it</source>
        <translation>Enter でこの名前で保存、Esc で中止</translation>
    </message>
    <message>
        <source>Sets the numbers to those of this preset; locked ones stay</source>
        <translation>数値をこのプリセットの値にする。ロックされたものは変わりません</translation>
    </message>
    <message>
        <source>New preset…</source>
        <translation>新しいプリセット…</translation>
    </message>
    <message>
        <source>Keeps the present values under a name, in a comment of the text</source>
        <translation>現在の値に名前を付け、テキストのコメントに保存する</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>更新</translation>
    </message>
    <message>
        <source>The preset takes the present values</source>
        <translation>プリセットを現在の値にする</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>名前を変更</translation>
    </message>
    <message>
        <source>Another name for the preset</source>
        <translation>プリセットを別の名前にする</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Takes the preset out of the text</source>
        <translation>プリセットをテキストから取り除く</translation>
    </message>
    <message>
        <source>Preset “%1” is set.</source>
        <translation>プリセット「%1」にしました。</translation>
    </message>
    <message>
        <source>Locked and left as they are: %1.</source>
        <translation>ロックのためそのまま: %1。</translation>
    </message>
    <message>
        <source>Not in the text: %1.</source>
        <translation>テキストにありません: %1。</translation>
    </message>
    <message>
        <source>Preset %1</source>
        <translation>プリセット %1</translation>
    </message>
    <message>
        <source>A preset needs a name.</source>
        <translation>プリセットには名前が必要です。</translation>
    </message>
    <message>
        <source>There is a preset “%1” already.</source>
        <translation>プリセット「%1」はすでにあります。</translation>
    </message>
</context>
<context>
    <name>isoscope::PreviewLight</name>
    <message>
        <source>An object has no pigment: POV-Ray shows it black.</source>
        <translation>オブジェクトに pigment がないため、POV-Ray は黒く表示します。</translation>
    </message>
    <message>
        <source>Light It in the Preview</source>
        <translation>プレビューで照らす</translation>
    </message>
    <message>
        <source>Show it in grey here; the text, exports and POV-Ray&apos;s picture stay black</source>
        <translation>ここでは灰色で表示する。テキスト、書き出し、POV-Ray の画像は黒のままです</translation>
    </message>
    <message>
        <source>Leave It Black</source>
        <translation>黒のままにする</translation>
    </message>
    <message>
        <source>Problems offers to add a pigment</source>
        <translation>「問題」で pigment を追加できます</translation>
    </message>
</context>
<context>
    <name>isoscope::ProblemsPanel</name>
    <message>
        <source>Error</source>
        <translation>エラー</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>省略</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>注記</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>メッセージ</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>場所</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>問題</translation>
    </message>
    <message>
        <source>What is wrong with the text, and what of it is not shown. Enter goes to the place</source>
        <translation>テキストの誤りと、表示されない部分。Enter でその場所へ</translation>
    </message>
    <message>
        <source>No problems. Everything in the text is shown.</source>
        <translation>問題はありません。テキストのすべてを表示しています。</translation>
    </message>
    <message>
        <source>%1 (%2 times)</source>
        <translation>%1 (%2 回)</translation>
    </message>
    <message>
        <source>Change the text so; Undo takes it back</source>
        <translation>テキストをこのように変える。元に戻すで取り消せます</translation>
    </message>
    <message>
        <source>Fix All %1</source>
        <translation>%1 件すべて修正</translation>
    </message>
    <message>
        <source>Do the same for every problem of this kind, as one step</source>
        <translation>この種類の問題すべてに、1 つの操作として同じことをする</translation>
    </message>
    <message>
        <source>Copy Message</source>
        <translation>メッセージをコピー</translation>
    </message>
    <message>
        <source>error</source>
        <translation>エラー</translation>
    </message>
    <message>
        <source>errors</source>
        <translation>エラー</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>warnings</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>省略</translation>
    </message>
    <message>
        <source>note</source>
        <translation>注記</translation>
    </message>
    <message>
        <source>notes</source>
        <translation>注記</translation>
    </message>
    <message>
        <source>Problems: %1</source>
        <translation>問題: %1</translation>
    </message>
</context>
<context>
    <name>isoscope::QuickFixer</name>
    <message>
        <source>The text has changed there.</source>
        <translation>そこのテキストは変わっています。</translation>
    </message>
    <message>
        <source>: done.</source>
        <translation>: 完了。</translation>
    </message>
    <message>
        <source>%1 changes made.</source>
        <translation>%1 か所変更しました。</translation>
    </message>
</context>
<context>
    <name>isoscope::RayPanel</name>
    <message>
        <source>The isosurface that is shown along the ray.</source>
        <translation>レイに沿って表示する等値面。</translation>
    </message>
    <message>
        <source>The one in front</source>
        <translation>手前のもの</translation>
    </message>
    <message>
        <source>Cones</source>
        <translation>円錐</translation>
    </message>
    <message>
        <source>What POV-Ray trusts: from each of its samples, how soon a function no steeper than max_gradient could reach the threshold. Between two cones that do not meet it, it looks no closer.</source>
        <translation>POV-Ray が信じるもの: 各サンプルから、傾きが max_gradient 以下の関数がしきい値に達しうる最短の距離。しきい値に届かない 2 つの円錐の間は詳しく調べません。</translation>
    </message>
    <message>
        <source>Show the cones of max_gradient</source>
        <translation>max_gradient の円錐を表示</translation>
    </message>
    <message>
        <source>Enclosures</source>
        <translation>包囲</translation>
    </message>
    <message>
        <source>How the exact picture finds the surface: the pieces in which the certified root finder encloses the function.</source>
        <translation>正確な画像が曲面を見つける方法: 保証付き求根法が関数を上下から囲む区間。</translation>
    </message>
    <message>
        <source>Show the enclosures of the exact picture</source>
        <translation>正確な画像の包囲を表示</translation>
    </message>
    <message>
        <source>Value under the mouse</source>
        <translation>マウス位置の値</translation>
    </message>
    <message>
        <source>ray</source>
        <translation>レイ</translation>
    </message>
    <message>
        <source>The function along the ray</source>
        <translation>レイに沿った関数</translation>
    </message>
    <message>
        <source>f − threshold along the ray; wheel to zoom, drag to shift, double-click for the whole ray</source>
        <translation>レイに沿った f − threshold。ホイールでズーム、ドラッグで移動、ダブルクリックでレイ全体</translation>
    </message>
    <message>
        <source>What happens along the ray</source>
        <translation>レイに沿って起こること</translation>
    </message>
    <message>
        <source>The scene has no isosurface.</source>
        <translation>シーンに等値面がありません。</translation>
    </message>
    <message>
        <source>Switch “Ray” on above the picture and click a pixel.</source>
        <translation>画像の上の「レイ」をオンにし、ピクセルをクリックしてください。</translation>
    </message>
    <message>
        <source>This ray passes the container by.</source>
        <translation>このレイはコンテナを通りません。</translation>
    </message>
    <message>
        <source>f − threshold along the ray</source>
        <translation>レイに沿った f − threshold</translation>
    </message>
    <message>
        <source>f − threshold</source>
        <translation>f − threshold</translation>
    </message>
    <message>
        <source>distance from the camera</source>
        <translation>カメラからの距離</translation>
    </message>
    <message>
        <source>surface %1</source>
        <translation>曲面 %1</translation>
    </message>
    <message>
        <source>POV-Ray %1</source>
        <translation>POV-Ray %1</translation>
    </message>
    <message>
        <source>enclosure</source>
        <translation>包囲</translation>
    </message>
    <message>
        <source>POV-Ray&apos;s samples</source>
        <translation>POV-Ray のサンプル</translation>
    </message>
    <message>
        <source>dismissed</source>
        <translation>棄却</translation>
    </message>
    <message>
        <source>dismissed wrongly</source>
        <translation>誤った棄却</translation>
    </message>
    <message>
        <source>at %1: %2</source>
        <translation>%1 で: %2</translation>
    </message>
    <message>
        <source>undefined</source>
        <translation>未定義</translation>
    </message>
</context>
<context>
    <name>isoscope::ReadingBar</name>
    <message>
        <source>Progress of reading</source>
        <translation>読み込みの進み具合</translation>
    </message>
    <message>
        <source>Where in the text is being read; loops lead back</source>
        <translation>テキストのどこを読んでいるか。ループでは戻ります</translation>
    </message>
    <message>
        <source>Place in the text</source>
        <translation>テキスト内の場所</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>End the reading of this text; what was shown before stays</source>
        <translation>このテキストの読み込みを終える。前の表示は残ります</translation>
    </message>
    <message>
        <source>Stop reading</source>
        <translation>読み込みを停止</translation>
    </message>
    <message>
        <source>Reading the text: %1 s, %2 steps</source>
        <translation>テキストを読み込み中: %1 秒、%2 ステップ</translation>
    </message>
</context>
<context>
    <name>isoscope::RecentFiles</name>
    <message>
        <source>No files yet</source>
        <translation>ファイルはまだありません</translation>
    </message>
    <message>
        <source>Clear list</source>
        <translation>一覧を消去</translation>
    </message>
    <message>
        <source>Forget these files; nothing is deleted</source>
        <translation>これらのファイルを忘れる。何も削除しません</translation>
    </message>
</context>
<context>
    <name>isoscope::RecoveryStore</name>
    <message>
        <source>Unsaved text cannot be kept in %1: %2.</source>
        <translation>未保存のテキストを %1 に保管できません: %2。</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>フォルダを作れません</translation>
    </message>
    <message>
        <source>its lock cannot be taken</source>
        <translation>ロックを取得できません</translation>
    </message>
</context>
<context>
    <name>isoscope::RepairPanel</name>
    <message>
        <source>line %1</source>
        <translation>%1 行目</translation>
    </message>
    <message>
        <source>%1, %2 times</source>
        <translation>%1、%2 回</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>%1 以上</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>%1 times as long</source>
        <translation>%1 倍の時間</translation>
    </message>
    <message>
        <source>Isosurface</source>
        <translation>等値面</translation>
    </message>
    <message>
        <source>Proven</source>
        <translation>証明済み</translation>
    </message>
    <message>
        <source>To write</source>
        <translation>書き込む値</translation>
    </message>
    <message>
        <source>Wrong pixels</source>
        <translation>誤ったピクセル</translation>
    </message>
    <message>
        <source>POV-Ray takes</source>
        <translation>POV-Ray の時間</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>Isosurfaces of the scene and its include files</source>
        <translation>シーンとインクルードファイルの等値面</translation>
    </message>
    <message>
        <source>What is ticked is written by the button below; a double click, or Enter, shows the place</source>
        <translation>チェックした値は下のボタンで書き込まれます。ダブルクリックか Enter で場所を表示します</translation>
    </message>
    <message>
        <source>include_file.inc:1000, 100 times_____</source>
        <translation>include_file.inc:1000、100 回_____</translation>
    </message>
    <message>
        <source>How far the isosurfaces are judged</source>
        <translation>等値面の判定の進み具合</translation>
    </message>
    <message>
        <source>Progress of the proofs</source>
        <translation>証明の進行状況</translation>
    </message>
    <message>
        <source>How many isosurfaces are judged</source>
        <translation>判定された等値面の数</translation>
    </message>
    <message>
        <source>Stop the proofs or go on</source>
        <translation>証明を停止または再開</translation>
    </message>
    <message>
        <source>Tick all or none</source>
        <translation>すべてチェックまたは解除</translation>
    </message>
    <message>
        <source>Writes what is ticked where it stands: into the text, where Undo takes it back, and into the include files in the folder of the scene; every other character stays</source>
        <translation>チェックした値をその場所に書き込みます: テキスト(元に戻せます)と、シーンのフォルダーにあるインクルードファイル。ほかの文字はすべてそのままです</translation>
    </message>
    <message>
        <source>Write the ticked values</source>
        <translation>チェックした値を書き込む</translation>
    </message>
    <message>
        <source>The file is not changed: %1.</source>
        <translation>ファイルは変更されません: %1。</translation>
    </message>
    <message>
        <source>The value cannot be written where the statement stands.</source>
        <translation>文のある場所には値を書き込めません。</translation>
    </message>
    <message>
        <source>Go On</source>
        <translation>再開</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Go on with the proofs</source>
        <translation>証明を再開する</translation>
    </message>
    <message>
        <source>End the proofs; what is known stays</source>
        <translation>証明を終える。わかったことは残る</translation>
    </message>
    <message>
        <source>The isosurfaces are being judged…</source>
        <translation>等値面を判定しています…</translation>
    </message>
    <message>
        <source>The scene shows no isosurface that has a max_gradient.</source>
        <translation>max_gradient を持つ等値面はシーンにありません。</translation>
    </message>
    <message>
        <source>%1 of %2 statements are judged.</source>
        <translation>%2 個の文のうち %1 個を判定しました。</translation>
    </message>
    <message>
        <source>There is nothing to repair.</source>
        <translation>修復するものはありません。</translation>
    </message>
    <message>
        <source>Wrong pixels and time are those of this view; what is written is proven for every view.</source>
        <translation>誤ったピクセルと時間はこの視点のものです。書き込む値はどの視点についても証明されています。</translation>
    </message>
    <message>
        <source>Tick All</source>
        <translation>すべてチェック</translation>
    </message>
    <message>
        <source>Tick None</source>
        <translation>すべて解除</translation>
    </message>
    <message>
        <source>Ticks all rows that can be written, or none</source>
        <translation>書き込める行をすべてチェックする、または解除する</translation>
    </message>
    <message>
        <source>Write 1 Value</source>
        <translation>1 個の値を書き込む</translation>
    </message>
    <message>
        <source>Write %1 Values</source>
        <translation>%1 個の値を書き込む</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>書き込む</translation>
    </message>
</context>
<context>
    <name>isoscope::ReportPanel</name>
    <message>
        <source>no value</source>
        <translation>値なし</translation>
    </message>
    <message>
        <source>infinite, or infinitely steep</source>
        <translation>無限、または傾きが無限</translation>
    </message>
    <message>
        <source>jumps by %1</source>
        <translation>%1 だけ跳ぶ</translation>
    </message>
    <message>
        <source>jumps</source>
        <translation>跳ぶ</translation>
    </message>
    <message>
        <source>digits lost: off by up to %1</source>
        <translation>桁落ち: 誤差は最大 %1</translation>
    </message>
    <message>
        <source>kink</source>
        <translation>折れ目</translation>
    </message>
    <message>
        <source>The isosurface that is reported on.</source>
        <translation>レポートの対象の等値面。</translation>
    </message>
    <message>
        <source>Report on the shape</source>
        <translation>形のレポート</translation>
    </message>
    <message>
        <source>What the solid is like, each with its proof or its error</source>
        <translation>立体の性質、それぞれ証明または誤差付き</translation>
    </message>
    <message>
        <source>What the chosen place does to the pictures</source>
        <translation>選んだ場所が画像に及ぼすこと</translation>
    </message>
    <message>
        <source>Progress of the report</source>
        <translation>レポートの進み具合</translation>
    </message>
    <message>
        <source>How much of the report is done</source>
        <translation>レポートがどこまでできたか</translation>
    </message>
    <message>
        <source>Report or stop</source>
        <translation>レポートまたは停止</translation>
    </message>
    <message>
        <source>The function has</source>
        <translation>関数の状態</translation>
    </message>
    <message>
        <source>From the surface</source>
        <translation>曲面から</translation>
    </message>
    <message>
        <source>Certainty</source>
        <translation>確かさ</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>場所</translation>
    </message>
    <message>
        <source>Places where the function is not healthy</source>
        <translation>関数に難がある場所</translation>
    </message>
    <message>
        <source>Go There</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Shows the place in the picture.</source>
        <translation>画像に場所を示します。</translation>
    </message>
    <message>
        <source>Show the chosen place in the picture</source>
        <translation>選んだ場所を画像に示す</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>レポート</translation>
    </message>
    <message>
        <source>End the work</source>
        <translation>作業を終える</translation>
    </message>
    <message>
        <source>Find out what the isosurface is like</source>
        <translation>等値面の性質を調べる</translation>
    </message>
    <message>
        <source>The scene has no isosurface.</source>
        <translation>シーンに等値面がありません。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Being found out…</source>
        <translation>調べています…</translation>
    </message>
    <message>
        <source>It is found out once nothing moves.</source>
        <translation>何も動かなくなると調べます。</translation>
    </message>
    <message>
        <source>at the surface</source>
        <translation>曲面上</translation>
    </message>
    <message>
        <source>%1 away</source>
        <translation>%1 離れて</translation>
    </message>
    <message>
        <source>met</source>
        <translation>確認</translation>
    </message>
    <message>
        <source>suspected</source>
        <translation>疑い</translation>
    </message>
    <message>
        <source>The function has a value and a slope everywhere in the container, and no kink.</source>
        <translation>関数はコンテナ内のどこでも値と傾きを持ち、折れ目はありません。</translation>
    </message>
    <message>
        <source>Choose a place to see it, and what it does to the pictures.</source>
        <translation>場所を選ぶと、その場所と画像への影響が見られます。</translation>
    </message>
    <message>
        <source>Choose a place to see it. The search ended early: there may be more.</source>
        <translation>場所を選ぶと見られます。探索は途中で終わったため、ほかにもあるかもしれません。</translation>
    </message>
    <message>
        <source>Remedy</source>
        <translation>対処</translation>
    </message>
    <message>
        <source>A click, or Enter, shows the place in the picture; a click on a remedy writes it</source>
        <translation>クリックか Enter で画像内の場所を表示します。対処をクリックすると書き込まれます</translation>
    </message>
    <message>
        <source>Rewrite</source>
        <translation>書き換え</translation>
    </message>
    <message>
        <source>Changes the text so; Undo takes it back.</source>
        <translation>テキストをそのように変えます。元に戻すで取り消せます。</translation>
    </message>
    <message>
        <source>Write the remedy of the chosen place into the text</source>
        <translation>選んだ場所の対処をテキストに書き込む</translation>
    </message>
    <message>
        <source>A click writes it: %1</source>
        <translation>クリックで書き込み: %1</translation>
    </message>
</context>
<context>
    <name>isoscope::SceneDisplay</name>
    <message>
        <source>The text has errors; what was understood of it is shown.</source>
        <translation>テキストに誤りがあります。理解できた分を表示しています。</translation>
    </message>
    <message>
        <source>The text has errors; the first picture, of the text before them, is under way.</source>
        <translation>テキストに誤りがあります。誤りの前のテキストの最初の画像を計算中です。</translation>
    </message>
    <message>
        <source>The text has errors; this is the picture from before.</source>
        <translation>テキストに誤りがあります。これは前の画像です。</translation>
    </message>
    <message>
        <source>The text has errors, listed under Problems; nothing can be shown yet.</source>
        <translation>テキストに誤りがあり、「問題」に一覧があります。まだ何も表示できません。</translation>
    </message>
</context>
<context>
    <name>isoscope::SceneEditor</name>
    <message>
        <source>Scene text</source>
        <translation>シーンのテキスト</translation>
    </message>
    <message>
        <source>The scene in POV-Ray&apos;s language. Ctrl with the up and down keys changes the number at the caret.</source>
        <translation>POV-Ray の言語によるシーン。Ctrl と上下キーでカーソル位置の数値が変わります。</translation>
    </message>
    <message>
        <source>The scene&apos;s text. Drag a number with Ctrl to change it.</source>
        <translation>シーンのテキスト。Ctrl を押しながら数値をドラッグすると変わります。</translation>
    </message>
    <message>
        <source>Drag with Ctrl changes the number, a click with Ctrl opens a slider for it</source>
        <translation>Ctrl+ドラッグで数値を変更、Ctrl+クリックでスライダーを開く</translation>
    </message>
</context>
<context>
    <name>isoscope::SceneLexer</name>
    <message>
        <source>Text</source>
        <translation>テキスト</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>コメント</translation>
    </message>
    <message>
        <source>String</source>
        <translation>文字列</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>数値</translation>
    </message>
    <message>
        <source>Directive</source>
        <translation>ディレクティブ</translation>
    </message>
    <message>
        <source>Keyword</source>
        <translation>キーワード</translation>
    </message>
    <message>
        <source>Function</source>
        <translation>関数</translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation>記号</translation>
    </message>
</context>
<context>
    <name>isoscope::SceneRepairer</name>
    <message>
        <source>The text is still being read; nothing is changed.</source>
        <translation>テキストはまだ読み込み中です。何も変更していません。</translation>
    </message>
    <message>
        <source>%1 is not changed: %2.</source>
        <translation>%1 は変更されません: %2。</translation>
    </message>
    <message>
        <source>Values of max_gradient were written into %1.</source>
        <translation>max_gradient の値を %1 に書き込みました。</translation>
    </message>
    <message>
        <source>Put Back</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Give the files the text that they had</source>
        <translation>ファイルを元のテキストに戻す</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Keep the files as they are now</source>
        <translation>ファイルを今のままにする</translation>
    </message>
    <message>
        <source>Not put back, for it has changed since or cannot be written: %1.</source>
        <translation>その後変更されたか書き込めないため、元に戻していません: %1。</translation>
    </message>
</context>
<context>
    <name>isoscope::SectionControls</name>
    <message>
        <source>The isosurface whose function is shown</source>
        <translation>関数を表示する等値面</translation>
    </message>
    <message>
        <source>Cut at a constant %1 (in the function&apos;s own coordinates)</source>
        <translation>%1 が一定の所で切る (関数自身の座標)</translation>
    </message>
    <message>
        <source>Plane across the %1 axis</source>
        <translation>%1 軸に垂直な平面</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>自由</translation>
    </message>
    <message>
        <source>Cut by a plane of any direction: turn it by its angles, or drag it in the picture</source>
        <translation>任意の向きの平面で切る: 角度で回すか、画像の中でドラッグします</translation>
    </message>
    <message>
        <source>Free plane</source>
        <translation>自由な平面</translation>
    </message>
    <message>
        <source>Where the plane lies; the ends are the container&apos;s walls</source>
        <translation>平面の位置。両端はコンテナの壁です</translation>
    </message>
    <message>
        <source>Position of the plane</source>
        <translation>平面の位置</translation>
    </message>
    <message>
        <source>Position of the plane as a number</source>
        <translation>数値による平面の位置</translation>
    </message>
    <message>
        <source>turn </source>
        <translation>回転 </translation>
    </message>
    <message>
        <source>Heading: how far the plane is turned about y</source>
        <translation>方位: y 軸まわりの平面の回転</translation>
    </message>
    <message>
        <source>Heading of the plane</source>
        <translation>平面の方位</translation>
    </message>
    <message>
        <source>tilt </source>
        <translation>傾き </translation>
    </message>
    <message>
        <source>Tilt: how far the plane leans back; at 90° it lies level</source>
        <translation>傾き: 平面が後ろへ倒れる角度。90° で水平です</translation>
    </message>
    <message>
        <source>Tilt of the plane</source>
        <translation>平面の傾き</translation>
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
        <translation>表示する量</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>等値線</translation>
    </message>
    <message>
        <source>Thin lines of equal value</source>
        <translation>値の等しい細い線</translation>
    </message>
    <message>
        <source>Show lines of equal value</source>
        <translation>等値線を表示</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>断面線</translation>
    </message>
    <message>
        <source>Chart the function along a line: drag in the section to draw one</source>
        <translation>線に沿った関数のグラフ。断面の中をドラッグして線を引きます</translation>
    </message>
    <message>
        <source>Profile along a line</source>
        <translation>線に沿ったグラフ</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Write the section, or its numbers, to a file</source>
        <translation>断面またはその数値をファイルに書く</translation>
    </message>
    <message>
        <source>Save the section or its numbers</source>
        <translation>断面またはその数値を保存</translation>
    </message>
    <message>
        <source>&amp;Picture (PNG)…</source>
        <translation>画像 (PNG)(&amp;P)…</translation>
    </message>
    <message>
        <source>&amp;Numbers (CSV)…</source>
        <translation>数値 (CSV)(&amp;N)…</translation>
    </message>
    <message>
        <source>P&amp;rofile</source>
        <translation>断面線(&amp;R)</translation>
    </message>
    <message>
        <source>The %1 of the plane</source>
        <translation>平面の%1</translation>
    </message>
    <message>
        <source>Distance of the plane from the middle of the container</source>
        <translation>コンテナの中央から平面までの距離</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>Value with the full colour</source>
        <translation>最も濃い色の値</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>距離</translation>
    </message>
    <message>
        <source>What the colours show: the function, how steep it is, or how far the surface is: (f − threshold) ÷ |∇f|, which is right near the surface</source>
        <translation>色の内容: 関数、その傾き、または曲面までの距離: (f − threshold) ÷ |∇f|。曲面の近くで正しい</translation>
    </message>
    <message>
        <source>What has the full colour, and by whose parts lines are drawn: the values of the function, the slope or the distance; auto: most values, or max_gradient</source>
        <translation>最も濃い色になる値で、線はその分割ごとに引かれる: 関数の値、傾き、または距離。自動: 大部分の値、または max_gradient</translation>
    </message>
</context>
<context>
    <name>isoscope::SectionPanel</name>
    <message>
        <source>Value of the function under the mouse</source>
        <translation>マウス位置の関数の値</translation>
    </message>
    <message>
        <source>profile</source>
        <translation>断面線</translation>
    </message>
    <message>
        <source>The container has no finite extent.</source>
        <translation>コンテナの広がりが有限ではありません。</translation>
    </message>
    <message>
        <source>The scene has no isosurface to cut.</source>
        <translation>シーンに切る等値面がありません。</translation>
    </message>
    <message>
        <source>through %1 across %2</source>
        <translation>%1 を通り %2 に垂直</translation>
    </message>
    <message>
        <source>at %1 = %2</source>
        <translation>%1 = %2 で</translation>
    </message>
    <message>
        <source>|∇f| %1; up to %2 here, max_gradient is %3</source>
        <translation>|∇f| %1。ここで最大 %2、max_gradient は %3</translation>
    </message>
    <message>
        <source>f − threshold %1</source>
        <translation>f − threshold %1</translation>
    </message>
    <message>
        <source>; hatched where f is undefined</source>
        <translation>。f が未定義の所は斜線</translation>
    </message>
    <message>
        <source>undefined</source>
        <translation>未定義</translation>
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
        <translation>断面を保存</translation>
    </message>
    <message>
        <source>Save Numbers</source>
        <translation>数値を保存</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>PNG 画像 (*.png)</translation>
    </message>
    <message>
        <source>CSV tables (*.csv)</source>
        <translation>CSV 表 (*.csv)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 を保存しました。</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>%1 に書き込めません。</translation>
    </message>
    <message>
        <source>f − threshold on the plane: blue is inside, orange outside, the bold line is the surface.
|∇f|: red where it is steeper than max_gradient.
distance: (f − threshold) ÷ |∇f|, how far the surface is, to first order.
Drag to move, wheel to zoom, double-click to see all. Hatched: f is undefined.</source>
        <translation>平面上の f − threshold: 青は内側、橙は外側、太線は曲面。
|∇f|: max_gradient より急な所は赤。
距離: (f − threshold) ÷ |∇f|。曲面までの一次近似の距離。
ドラッグで移動、ホイールでズーム、ダブルクリックで全体。斜線: f が未定義。</translation>
    </message>
    <message>
        <source>distance to the surface %1</source>
        <translation>曲面までの距離 %1</translation>
    </message>
    <message>
        <source>, distance = %1</source>
        <translation>, 距離 = %1</translation>
    </message>
</context>
<context>
    <name>isoscope::SectionProfile</name>
    <message>
        <source>The function along the line</source>
        <translation>線に沿った関数</translation>
    </message>
    <message>
        <source>The quantity of the colours along the line from A to B; the dashed lines are where it passes the threshold</source>
        <translation>A から B への線に沿った色の量。破線はしきい値を通る所です</translation>
    </message>
    <message>
        <source>Value along the line under the mouse</source>
        <translation>マウス位置の線上の値</translation>
    </message>
    <message>
        <source>Draw a line in the section.</source>
        <translation>断面の中に線を引いてください。</translation>
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
        <translation>A からの距離</translation>
    </message>
    <message>
        <source>Along the line from A to B</source>
        <translation>A から B への線に沿って</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>%1 から %2</translation>
    </message>
    <message>
        <source>undefined</source>
        <translation>未定義</translation>
    </message>
    <message>
        <source>%1: f − threshold = %2, |∇f| = %3</source>
        <translation>%1: f − threshold = %2, |∇f| = %3</translation>
    </message>
    <message>
        <source>, distance = %1</source>
        <translation>, 距離 = %1</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>距離</translation>
    </message>
</context>
<context>
    <name>isoscope::SectionView</name>
    <message>
        <source>Cross-section of the function</source>
        <translation>関数の断面</translation>
    </message>
    <message>
        <source>%1, %2 away</source>
        <translation>%1、%2 離れて</translation>
    </message>
</context>
<context>
    <name>isoscope::SettingWriter</name>
    <message>
        <source>%1 values of max_gradient are changed.</source>
        <translation>max_gradient の値を %1 個変更しました。</translation>
    </message>
    <message>
        <source>The isosurface does not stand in the text itself; its %1 is not changed.</source>
        <translation>等値面はこのテキスト自体にないため、その %1 を変更しません。</translation>
    </message>
    <message>
        <source>%1 is %2 now.</source>
        <translation>%1 を %2 にしました。</translation>
    </message>
    <message>
        <source>The isosurface does not stand in the text itself; it is not changed.</source>
        <translation>等値面はこのテキスト自体にないため、変更しません。</translation>
    </message>
    <message>
        <source>The isosurface has evaluate now.</source>
        <translation>等値面に evaluate を設定しました。</translation>
    </message>
</context>
<context>
    <name>isoscope::SheetPanel</name>
    <message>
        <source>Draw the sheet, or stop</source>
        <translation>シートを描画または停止</translation>
    </message>
    <message>
        <source>Progress of the sheet</source>
        <translation>シートの進み具合</translation>
    </message>
    <message>
        <source>How many of the pictures are drawn</source>
        <translation>画像をどこまで描いたか</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>保存…</translation>
    </message>
    <message>
        <source>Write the sheet to a PNG file</source>
        <translation>シートを PNG ファイルに書く</translation>
    </message>
    <message>
        <source>Save the sheet</source>
        <translation>シートを保存</translation>
    </message>
    <message>
        <source>Click a picture to set its values in the text</source>
        <translation>画像をクリックするとその値をテキストに書く</translation>
    </message>
    <message>
        <source>Sheet of small pictures</source>
        <translation>小さな画像のシート</translation>
    </message>
    <message>
        <source>About the sheet</source>
        <translation>シートについて</translation>
    </message>
    <message>
        <source>down</source>
        <translation>縦</translation>
    </message>
    <message>
        <source>across</source>
        <translation>横</translation>
    </message>
    <message>
        <source>The number whose values go down, if there is to be a second one</source>
        <translation>縦に値を変える数値 (2 つ目を使う場合)</translation>
    </message>
    <message>
        <source>The number whose values go across</source>
        <translation>横に値を変える数値</translation>
    </message>
    <message>
        <source>from</source>
        <translation>始</translation>
    </message>
    <message>
        <source>First value</source>
        <translation>最初の値</translation>
    </message>
    <message>
        <source>to</source>
        <translation>終</translation>
    </message>
    <message>
        <source>Last value</source>
        <translation>最後の値</translation>
    </message>
    <message>
        <source>Number of values</source>
        <translation>値の個数</translation>
    </message>
    <message>
        <source>How many values are drawn</source>
        <translation>描く値の個数</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>(no second number)</source>
        <translation>(2 つ目の数値なし)</translation>
    </message>
    <message>
        <source>The text is still being read, or has errors.</source>
        <translation>テキストを読み込み中か、エラーがあります。</translation>
    </message>
    <message>
        <source>The sheet would be too large.</source>
        <translation>シートが大きくなりすぎます。</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>sheet</source>
        <translation>シート</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>PNG 画像 (*.png)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 を保存しました。</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>%1 に書き込めません。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>描画</translation>
    </message>
    <message>
        <source>End the drawing; what is drawn stays</source>
        <translation>描画を終える。描いた分は残ります</translation>
    </message>
    <message>
        <source>Draw the scene in small for each of the values</source>
        <translation>各値でのシーンを小さく描く</translation>
    </message>
    <message>
        <source>Choose one number, or two, and press Draw.</source>
        <translation>数値を 1 つか 2 つ選び、「描画」を押してください。</translation>
    </message>
    <message>
        <source>The scene has no number to vary.</source>
        <translation>変化させる数値がシーンにありません。</translation>
    </message>
    <message>
        <source>Stopped early: %1 of %2 pictures.</source>
        <translation>途中で停止: %2 枚中 %1 枚の画像。</translation>
    </message>
    <message>
        <source>Click a picture to set its values in the text.</source>
        <translation>画像をクリックするとその値をテキストに書きます。</translation>
    </message>
    <message>
        <source> values</source>
        <translation> 個</translation>
    </message>
</context>
<context>
    <name>isoscope::ShortcutWindow</name>
    <message>
        <source>Keyboard and mouse</source>
        <translation>キーボードとマウス</translation>
    </message>
    <message>
        <source>Search commands and keys</source>
        <translation>コマンドとキーを検索</translation>
    </message>
    <message>
        <source>Shows only lines that contain these words</source>
        <translation>これらの単語を含む行だけを表示する</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>Keys or mouse</source>
        <translation>キーまたはマウス</translation>
    </message>
    <message>
        <source>Commands with their keys</source>
        <translation>コマンドとキー</translation>
    </message>
    <message>
        <source>Enter or a double click goes to the field for the command&apos;s keys</source>
        <translation>Enter かダブルクリックでコマンドのキーの欄へ</translation>
    </message>
    <message>
        <source>Reset All</source>
        <translation>すべて戻す</translation>
    </message>
    <message>
        <source>Give every command the keys that the program comes with</source>
        <translation>すべてのコマンドのキーを最初の設定に戻す</translation>
    </message>
    <message>
        <source>New keys</source>
        <translation>新しいキー</translation>
    </message>
    <message>
        <source>Press the keys that shall call the command</source>
        <translation>コマンドを呼ぶキーを押す</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>Give the command these keys</source>
        <translation>コマンドにこのキーを割り当てる</translation>
    </message>
    <message>
        <source>No Keys</source>
        <translation>キーなし</translation>
    </message>
    <message>
        <source>Take the command&apos;s keys away</source>
        <translation>コマンドのキーを外す</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>戻す</translation>
    </message>
    <message>
        <source>Give the command the keys that it came with</source>
        <translation>コマンドのキーを最初の設定に戻す</translation>
    </message>
    <message>
        <source>What these keys would do</source>
        <translation>このキーのはたらき</translation>
    </message>
    <message>
        <source>Keys of “%1”:</source>
        <translation>「%1」のキー:</translation>
    </message>
    <message>
        <source>Choose a command to change its keys.</source>
        <translation>キーを変えるコマンドを選んでください。</translation>
    </message>
    <message>
        <source>“%1” has these keys now and would lose them.</source>
        <translation>このキーは今「%1」のもので、割り当てると外れます。</translation>
    </message>
    <message>
        <source>These keys are free.</source>
        <translation>このキーは空いています。</translation>
    </message>
</context>
<context>
    <name>isoscope::SliderNotePopup</name>
    <message>
        <source>Range, step and scale of %1</source>
        <translation>%1 の範囲、ステップ、目盛り</translation>
    </message>
    <message>
        <source>Enter sets the values, Esc leaves them as they are</source>
        <translation>Enter で値を設定、Esc でそのまま</translation>
    </message>
    <message>
        <source>&amp;From</source>
        <translation>最小(&amp;F)</translation>
    </message>
    <message>
        <source>Lower end of the slider</source>
        <translation>スライダーの下端</translation>
    </message>
    <message>
        <source>&amp;To</source>
        <translation>最大(&amp;T)</translation>
    </message>
    <message>
        <source>Upper end of the slider</source>
        <translation>スライダーの上端</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>ステップ(&amp;S)</translation>
    </message>
    <message>
        <source>How far apart values are; empty: as fine as the slider is</source>
        <translation>値の間隔。空: スライダーの細かさのとおり</translation>
    </message>
    <message>
        <source>fine</source>
        <translation>細かく</translation>
    </message>
    <message>
        <source>&amp;Decimals</source>
        <translation>小数桁(&amp;D)</translation>
    </message>
    <message>
        <source>Digits behind the point that are written; empty: as many as needed</source>
        <translation>書かれる小数点以下の桁数。空: 必要なだけ</translation>
    </message>
    <message>
        <source>as needed</source>
        <translation>必要なだけ</translation>
    </message>
    <message>
        <source>&amp;Logarithmic</source>
        <translation>対数(&amp;L)</translation>
    </message>
    <message>
        <source>Equal ways multiply the number; the lower end must be above 0</source>
        <translation>同じ移動量で同じ倍率になる。下端は 0 より大きくします</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>Writes the values into the text, in a comment behind the number</source>
        <translation>値を数値の後のコメントとしてテキストに書く</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>From and To must be numbers.</source>
        <translation>最小と最大は数値にします。</translation>
    </message>
    <message>
        <source>From must be less than To.</source>
        <translation>最小は最大より小さくします。</translation>
    </message>
    <message>
        <source>A logarithmic slider must begin above 0.</source>
        <translation>対数スライダーは 0 より上から始めます。</translation>
    </message>
    <message>
        <source>The step must be above 0 and fit between From and To.</source>
        <translation>ステップは 0 より大きく、最小と最大の間に収まる値にします。</translation>
    </message>
    <message>
        <source>Decimals must be a whole number from 0 to %1.</source>
        <translation>小数桁は 0 から %1 までの整数にします。</translation>
    </message>
</context>
<context>
    <name>isoscope::StartPage</name>
    <message>
        <source>Start page</source>
        <translation>スタートページ</translation>
    </message>
    <message>
        <source>&lt;p&gt;Scenes to begin with. A click opens one; everything in it can be changed.&lt;/p&gt;</source>
        <translation>&lt;p&gt;始めるためのシーン。クリックで開き、中のすべてを変えられます。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Begin with a picture</source>
        <translation>画像から始める</translation>
    </message>
    <message>
        <source>Choose one: its text opens at the left, and every number in it becomes a slider.</source>
        <translation>1 つ選ぶと、そのテキストが左に開き、すべての数値がスライダーになります。</translation>
    </message>
    <message>
        <source>Show this page at each start</source>
        <translation>起動のたびにこのページを表示</translation>
    </message>
    <message>
        <source>Otherwise File, Start Page opens it</source>
        <translation>表示しない場合はファイル、スタートページで開きます</translation>
    </message>
    <message>
        <source>New Scene</source>
        <translation>新しいシーン</translation>
    </message>
    <message>
        <source>Begin with an empty scene</source>
        <translation>空のシーンから始める</translation>
    </message>
    <message>
        <source>Open File…</source>
        <translation>ファイルを開く…</translation>
    </message>
    <message>
        <source>Open a scene or include file</source>
        <translation>シーンまたはインクルードファイルを開く</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>レッスン</translation>
    </message>
    <message>
        <source>Read the short lessons about isosurfaces</source>
        <translation>等値面についての短いレッスンを読む</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Go on with the scene that is open (Esc)</source>
        <translation>開いているシーンで続ける (Esc)</translation>
    </message>
</context>
<context>
    <name>isoscope::StudyController</name>
    <message>
        <source>There are no two isosurfaces to compare.</source>
        <translation>比べる 2 つの等値面がありません。</translation>
    </message>
    <message>
        <source>The difference surface, f kept less f now, is on the clipboard.</source>
        <translation>差の曲面 (保管した f 引く現在の f) をクリップボードに入れました。</translation>
    </message>
</context>
<context>
    <name>isoscope::SurfaceChooser</name>
    <message>
        <source>Isosurface</source>
        <translation>等値面</translation>
    </message>
    <message>
        <source>Isosurface %1</source>
        <translation>等値面 %1</translation>
    </message>
</context>
<context>
    <name>isoscope::SweepPanel</name>
    <message>
        <source>The number whose values are tried</source>
        <translation>値を試す数値</translation>
    </message>
    <message>
        <source>Number that is varied</source>
        <translation>変化させる数値</translation>
    </message>
    <message>
        <source>from</source>
        <translation>始</translation>
    </message>
    <message>
        <source>First value</source>
        <translation>最初の値</translation>
    </message>
    <message>
        <source>to</source>
        <translation>終</translation>
    </message>
    <message>
        <source>Last value</source>
        <translation>最後の値</translation>
    </message>
    <message>
        <source>Number of values</source>
        <translation>値の個数</translation>
    </message>
    <message>
        <source>How many values are tried</source>
        <translation>試す値の個数</translation>
    </message>
    <message>
        <source>Measure or stop</source>
        <translation>測定または停止</translation>
    </message>
    <message>
        <source>Progress of the measurement</source>
        <translation>測定の進み具合</translation>
    </message>
    <message>
        <source>How much of the measurement is done</source>
        <translation>測定がどこまで進んだか</translation>
    </message>
    <message>
        <source>About the measurement</source>
        <translation>測定について</translation>
    </message>
    <message>
        <source>sweep</source>
        <translation>スイープ</translation>
    </message>
    <message>
        <source>Pieces, tunnels, hollows</source>
        <translation>部分、トンネル、空洞</translation>
    </message>
    <message>
        <source>Largest gradient</source>
        <translation>最大の勾配</translation>
    </message>
    <message>
        <source>What the right chart shows</source>
        <translation>右のグラフの内容</translation>
    </message>
    <message>
        <source>Evaluations per pixel</source>
        <translation>ピクセルあたりの評価回数</translation>
    </message>
    <message>
        <source>Click to write a value into the text</source>
        <translation>クリックで値をテキストに書く</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Measure Again</source>
        <translation>再測定</translation>
    </message>
    <message>
        <source>End the measurement; what is measured stays</source>
        <translation>測定を終える。測定済みの分は残ります</translation>
    </message>
    <message>
        <source>Try the values of the number in small pictures</source>
        <translation>小さな画像で数値の値を試す</translation>
    </message>
    <message>
        <source>It is measured as soon as nothing moves.</source>
        <translation>何も動かなくなると測定します。</translation>
    </message>
    <message>
        <source>The scene has no isosurface with a number to vary.</source>
        <translation>変化させる数値を持つ等値面がシーンにありません。</translation>
    </message>
    <message>
        <source>POV-Ray</source>
        <translation>POV-Ray</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>正確</translation>
    </message>
    <message>
        <source>attained</source>
        <translation>到達</translation>
    </message>
    <message>
        <source>proven</source>
        <translation>証明</translation>
    </message>
    <message>
        <source>pieces</source>
        <translation>部分</translation>
    </message>
    <message>
        <source>tunnels</source>
        <translation>トンネル</translation>
    </message>
    <message>
        <source>hollows</source>
        <translation>空洞</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>現在 %1</translation>
    </message>
    <message>
        <source>Chart of %1 over %2</source>
        <translation>%2 に対する %1 のグラフ</translation>
    </message>
    <message>
        <source>Measured before the last change of scene or view.</source>
        <translation>シーンやビューの最後の変更より前の測定です。</translation>
    </message>
    <message>
        <source>Stopped early.</source>
        <translation>途中で停止しました。</translation>
    </message>
    <message>
        <source>Evaluations of the camera&apos;s rays; pieces of a grid of %1 cells.</source>
        <translation>カメラのレイの評価回数。部分は %1 セルの格子によります。</translation>
    </message>
    <message>
        <source>The scene cannot be read for %1 of the values.</source>
        <translation>%1 個の値ではシーンを読めません。</translation>
    </message>
    <message>
        <source> values</source>
        <translation> 個</translation>
    </message>
</context>
<context>
    <name>isoscope::ThresholdPanel</name>
    <message>
        <source>proven</source>
        <translation>証明</translation>
    </message>
    <message>
        <source>suspected: the search ended before</source>
        <translation>疑い: 探索がその前に終了</translation>
    </message>
    <message>
        <source>suspected: at the container&apos;s wall</source>
        <translation>疑い: コンテナの壁</translation>
    </message>
    <message>
        <source>suspected: the function is constant there</source>
        <translation>疑い: 関数がそこで一定</translation>
    </message>
    <message>
        <source>suspected: more than a point</source>
        <translation>疑い: 点より広い</translation>
    </message>
    <message>
        <source>suspected: a kink</source>
        <translation>疑い: 折れ目</translation>
    </message>
    <message>
        <source>suspected: no bound of the gradient</source>
        <translation>疑い: 勾配の上界なし</translation>
    </message>
    <message>
        <source>; </source>
        <translation>、</translation>
    </message>
    <message>
        <source> (×%1)</source>
        <translation> (×%1)</translation>
    </message>
    <message>
        <source>The isosurface whose threshold is looked at.</source>
        <translation>しきい値を調べる等値面。</translation>
    </message>
    <message>
        <source>Histogram of the function</source>
        <translation>関数のヒストグラム</translation>
    </message>
    <message>
        <source>How much of the container has which value of the function. Drag to move the threshold; it sticks to the lines, at which the surface changes its form.</source>
        <translation>コンテナのどれだけが関数のどの値を持つか。ドラッグでしきい値を動かすと、曲面の形が変わる線に吸い付きます。</translation>
    </message>
    <message>
        <source>About the threshold</source>
        <translation>しきい値について</translation>
    </message>
    <message>
        <source>Progress of the search</source>
        <translation>探索の進み具合</translation>
    </message>
    <message>
        <source>How much of the search for critical values is done</source>
        <translation>臨界値の探索がどこまで進んだか</translation>
    </message>
    <message>
        <source>Search or stop</source>
        <translation>探索または停止</translation>
    </message>
    <message>
        <source>threshold</source>
        <translation>しきい値</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>しきい値</translation>
    </message>
    <message>
        <source>What happens as it rises</source>
        <translation>上がるときの変化</translation>
    </message>
    <message>
        <source>Certainty</source>
        <translation>確かさ</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>場所</translation>
    </message>
    <message>
        <source>Thresholds at which the surface changes its form</source>
        <translation>曲面の形が変わるしきい値</translation>
    </message>
    <message>
        <source>A double click, or Enter, sets the threshold</source>
        <translation>ダブルクリックか Enter でしきい値を設定</translation>
    </message>
    <message>
        <source>two pieces join or a tunnel opens (×88)</source>
        <translation>2 つの部分がつながる、トンネルが開く (×88)</translation>
    </message>
    <message>
        <source>suspected: a kink_</source>
        <translation>疑い: 折れ目_</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>使う</translation>
    </message>
    <message>
        <source>Go There</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Writes this threshold into the text.</source>
        <translation>このしきい値をテキストに書きます。</translation>
    </message>
    <message>
        <source>Use the chosen threshold</source>
        <translation>選んだしきい値を使う</translation>
    </message>
    <message>
        <source>Shows the place where it happens in the picture.</source>
        <translation>それが起こる場所を画像に示します。</translation>
    </message>
    <message>
        <source>Show the place of the chosen threshold</source>
        <translation>選んだしきい値の場所を示す</translation>
    </message>
    <message>
        <source>The values of the function are shown here once nothing moves.</source>
        <translation>関数の値は、何も動かなくなるとここに表示されます。</translation>
    </message>
    <message>
        <source>The scene has no isosurface.</source>
        <translation>シーンに等値面がありません。</translation>
    </message>
    <message>
        <source>Distribution of the function</source>
        <translation>関数の分布</translation>
    </message>
    <message>
        <source>in the container</source>
        <translation>コンテナ内</translation>
    </message>
    <message>
        <source>pieces or hollows appear, go</source>
        <translation>部分・空洞の出現、消滅</translation>
    </message>
    <message>
        <source>pieces join, tunnels</source>
        <translation>部分の結合、トンネル</translation>
    </message>
    <message>
        <source>suspected</source>
        <translation>疑い</translation>
    </message>
    <message>
        <source>threshold %1</source>
        <translation>しきい値 %1</translation>
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
        <translation>下がるときの変化</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>探索</translation>
    </message>
    <message>
        <source>End the search for critical values</source>
        <translation>臨界値の探索を終える</translation>
    </message>
    <message>
        <source>Search for the values at which the surface changes its form</source>
        <translation>曲面の形が変わる値を探す</translation>
    </message>
    <message>
        <source>%1 of the container is inside.</source>
        <translation>コンテナの %1 が内側です。</translation>
    </message>
    <message>
        <source>Values at which its form changes: %1 proven, %2 suspected, no others but at the container&apos;s wall.</source>
        <translation>形が変わる値: 証明済み %1、疑い %2。コンテナの壁を除きほかにありません。</translation>
    </message>
    <message>
        <source>The first %1 are listed.</source>
        <translation>最初の %1 個を一覧しています。</translation>
    </message>
    <message>
        <source>Where the function jumps there may be more.</source>
        <translation>関数が跳ぶ所ではほかにもあるかもしれません。</translation>
    </message>
</context>
<context>
    <name>isoscope::TimelineController</name>
    <message>
        <source>Nothing differs from its keys at this frame.</source>
        <translation>このフレームでキーと異なるものはありません。</translation>
    </message>
</context>
<context>
    <name>isoscope::TimelinePanel</name>
    <message>
        <source>Timeline</source>
        <translation>タイムライン</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>最初のフレーム</translation>
    </message>
    <message>
        <source>Go to the first frame</source>
        <translation>最初のフレームへ</translation>
    </message>
    <message>
        <source>Play the animation</source>
        <translation>アニメーションを再生</translation>
    </message>
    <message>
        <source>Play the frames in their time; Esc stops</source>
        <translation>フレームを実時間で再生する。Esc で停止</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>最後のフレーム</translation>
    </message>
    <message>
        <source>Go to the last frame</source>
        <translation>最後のフレームへ</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>繰り返し</translation>
    </message>
    <message>
        <source>Begin anew at the last frame</source>
        <translation>最後のフレームで初めに戻る</translation>
    </message>
    <message>
        <source>F&amp;rame</source>
        <translation>フレーム(&amp;R)</translation>
    </message>
    <message>
        <source>Present frame</source>
        <translation>現在のフレーム</translation>
    </message>
    <message>
        <source>The frame that is shown</source>
        <translation>表示中のフレーム</translation>
    </message>
    <message>
        <source>Set Key</source>
        <translation>キーを置く</translation>
    </message>
    <message>
        <source>Keep the present value of a number, or the view, at this frame; in the text</source>
        <translation>数値の現在の値またはビューを、このフレームとしてテキストに保存する</translation>
    </message>
    <message>
        <source>Remove key</source>
        <translation>キーを削除</translation>
    </message>
    <message>
        <source>Take the key of the chosen row at this frame away (Delete)</source>
        <translation>選んだ行のこのフレームのキーを取り除く (Delete)</translation>
    </message>
    <message>
        <source>Way to the next key</source>
        <translation>次のキーへの動き</translation>
    </message>
    <message>
        <source>How the value goes from the key of the chosen row at this frame to its next one</source>
        <translation>選んだ行のこのフレームのキーから次のキーへ値がどう変わるか</translation>
    </message>
    <message>
        <source>Fra&amp;mes</source>
        <translation>全体(&amp;M)</translation>
    </message>
    <message>
        <source>First frame of the animation</source>
        <translation>アニメーションの最初のフレーム</translation>
    </message>
    <message>
        <source>Number of the first frame</source>
        <translation>最初のフレームの番号</translation>
    </message>
    <message>
        <source>to</source>
        <translation>終</translation>
    </message>
    <message>
        <source>Last frame of the animation</source>
        <translation>アニメーションの最後のフレーム</translation>
    </message>
    <message>
        <source>Number of the last frame</source>
        <translation>最後のフレームの番号</translation>
    </message>
    <message>
        <source>Frames per second</source>
        <translation>1 秒あたりのフレーム数</translation>
    </message>
    <message>
        <source>How fast the animation plays</source>
        <translation>アニメーションの速さ</translation>
    </message>
    <message>
        <source>per second</source>
        <translation>毎秒</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>書き出し</translation>
    </message>
    <message>
        <source>Draw all frames into pictures, and a film where ffmpeg is installed</source>
        <translation>すべてのフレームを画像に描き、ffmpeg があれば動画にする</translation>
    </message>
    <message>
        <source>cl&amp;ock</source>
        <translation>cl&amp;ock</translation>
    </message>
    <message>
        <source>Clock of the first frame</source>
        <translation>最初のフレームの clock</translation>
    </message>
    <message>
        <source>The value of clock in the first frame, for the text and for POV-Ray</source>
        <translation>最初のフレームでの clock の値、テキストと POV-Ray 用</translation>
    </message>
    <message>
        <source>Clock of the last frame</source>
        <translation>最後のフレームの clock</translation>
    </message>
    <message>
        <source>The value of clock in the last frame, for the text and for POV-Ray</source>
        <translation>最後のフレームでの clock の値、テキストと POV-Ray 用</translation>
    </message>
    <message>
        <source>Stop the animation</source>
        <translation>アニメーションを停止</translation>
    </message>
    <message>
        <source>What differs from its keys</source>
        <translation>キーと異なるもの</translation>
    </message>
    <message>
        <source>A key for each number with keys, and for the view, that differs from them now</source>
        <translation>キーを持つ数値とビューのうち、今キーと異なるものそれぞれのキー</translation>
    </message>
    <message>
        <source>View</source>
        <translation>ビュー</translation>
    </message>
    <message>
        <source>A key for the camera: the present view</source>
        <translation>カメラのキー: 現在のビュー</translation>
    </message>
    <message>
        <source>A key for this number: its present value</source>
        <translation>この数値のキー: 現在の値</translation>
    </message>
</context>
<context>
    <name>isoscope::TimelineView</name>
    <message>
        <source>Frames and keys</source>
        <translation>フレームとキー</translation>
    </message>
    <message>
        <source>Drag to go to a frame, drag a key to move it; a right click on a key has more</source>
        <translation>ドラッグでフレームへ移動、キーのドラッグで移動。キーの右クリックでほかの操作</translation>
    </message>
    <message>
        <source>Frame %1 of %2 to %3</source>
        <translation>フレーム %1 (%2～%3)</translation>
    </message>
    <message>
        <source>%1 has no key here</source>
        <translation>%1 のキーはここにありません</translation>
    </message>
    <message>
        <source>%1 (not in the text)</source>
        <translation>%1 (テキストにありません)</translation>
    </message>
    <message>
        <source>No keys yet: go to a frame, move a slider or the view, and choose Set Key.</source>
        <translation>キーはまだありません。フレームへ移り、スライダーかビューを動かし、「キーを置く」を選んでください。</translation>
    </message>
</context>
<context>
    <name>isoscope::VerdictBadge</name>
    <message>
        <source>isosurface in line %1</source>
        <translation>%1 行の等値面</translation>
    </message>
    <message>
        <source>isosurface %1</source>
        <translation>等値面 %1</translation>
    </message>
    <message>
        <source>no holes: proven</source>
        <translation>穴なし: 証明済み</translation>
    </message>
    <message>
        <source>holes: %1</source>
        <translation>穴: %1</translation>
    </message>
    <message>
        <source>%1 × slower than need be</source>
        <translation>必要より %1 倍遅い</translation>
    </message>
    <message>
        <source>&lt;p&gt;Whether POV-Ray&apos;s picture of the isosurfaces of this text has holes, or takes longer than it has to. This is proven in the background, for every isosurface; the badge tells the worst.&lt;/p&gt;&lt;p&gt;POV-Ray&apos;s root finder trusts &lt;b&gt;max_gradient&lt;/b&gt;: where the function is steeper, it steps over the surface. Click to see the numbers in the panel “Gradient”.&lt;/p&gt;</source>
        <translation>&lt;p&gt;このテキストの等値面の POV-Ray の画像に穴があるか、必要以上に時間がかかるか。すべての等値面について背景で証明し、バッジは最も悪いものを示します。&lt;/p&gt;&lt;p&gt;POV-Ray の求根法は &lt;b&gt;max_gradient&lt;/b&gt; を信じ、関数がより急な所では曲面を飛び越えます。クリックするとパネル「勾配」に数値を表示します。&lt;/p&gt;</translation>
    </message>
    <message>
        <source> (%1 of %2)</source>
        <translation> (%1 / %2)</translation>
    </message>
    <message>
        <source>&lt;p&gt;%1 more.&lt;/p&gt;</source>
        <translation>&lt;p&gt;ほか %1 件。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Verdict on max_gradient: %1</source>
        <translation>max_gradient の判定: %1</translation>
    </message>
    <message>
        <source>Use %1: %2</source>
        <translation>%1 を使う: %2</translation>
    </message>
    <message>
        <source>Fix All %1</source>
        <translation>%1 件すべて修正</translation>
    </message>
    <message>
        <source>Still reading…</source>
        <translation>読み込み中…</translation>
    </message>
    <message>
        <source>The text is still being read; its isosurfaces are judged afterwards.</source>
        <translation>テキストを読み込み中です。等値面はその後で判定します。</translation>
    </message>
    <message>
        <source>Verdict on max_gradient: the text is still being read</source>
        <translation>max_gradient の判定: テキストを読み込み中</translation>
    </message>
</context>
<context>
    <name>isoscope::VerdictController</name>
    <message>
        <source>infinitely steep</source>
        <translation>傾きが無限</translation>
    </message>
    <message>
        <source>steepest: %1</source>
        <translation>最も急: %1</translation>
    </message>
    <message>
        <source>No problems. Everything in the text is shown.</source>
        <translation>問題はありません。テキストのすべてを表示しています。</translation>
    </message>
    <message>
        <source>The text is still being read.</source>
        <translation>テキストを読んでいる途中です。</translation>
    </message>
    <message>
        <source>The text has no mistakes.</source>
        <translation>テキストに誤りはありません。</translation>
    </message>
    <message>
        <source>No problems so far. Whether POV-Ray&apos;s picture has holes is being found out.</source>
        <translation>今のところ問題はありません。POV-Ray の画像に穴があるか調べています。</translation>
    </message>
    <message>
        <source>POV-Ray&apos;s picture has no holes: that is proven.</source>
        <translation>POV-Ray の画像に穴がないことは証明済みです。</translation>
    </message>
</context>
<context>
    <name>isoscope::ViewController</name>
    <message>
        <source>There is nothing to fit: what the scene shows is empty, or has no end.</source>
        <translation>収めるものがありません。シーンの内容が空か、無限に広がっています。</translation>
    </message>
</context>
<context>
    <name>isoscope::ViewOverlay</name>
    <message>
        <source>The pictures cannot be compared.</source>
        <translation>画像を比較できません。</translation>
    </message>
    <message>
        <source>There is no text that POV-Ray could draw.</source>
        <translation>POV-Ray が描けるテキストがありません。</translation>
    </message>
    <message>
        <source>POV-Ray draws the picture…</source>
        <translation>POV-Ray が画像を描いています…</translation>
    </message>
    <message>
        <source>Measuring the gradient on the surface…</source>
        <translation>曲面上の勾配を測定中…</translation>
    </message>
    <message>
        <source>Comparing POV-Ray&apos;s picture with the exact one…</source>
        <translation>POV-Ray の画像と正確な画像を比較中…</translation>
    </message>
    <message>
        <source>Stopped. Redraw the picture to see it.</source>
        <translation>停止しました。見るには画像を再描画してください。</translation>
    </message>
    <message>
        <source>Waits for the picture.</source>
        <translation>画像を待っています。</translation>
    </message>
    <message>
        <source>Nothing is kept. Choose Compare again to keep the scene as it is.</source>
        <translation>何も保管されていません。再び「比較」を選ぶと、現在のシーンを保管します。</translation>
    </message>
    <message>
        <source>Drawing the kept scene…</source>
        <translation>保管したシーンを描画中…</translation>
    </message>
    <message>
        <source>Left of the divider the kept scene, right of it the present one</source>
        <translation>境界の左は保管したシーン、右は現在のシーン</translation>
    </message>
    <message>
        <source>POV-Ray itself</source>
        <translation>POV-Ray 本体</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>正確</translation>
    </message>
    <message>
        <source>A, kept</source>
        <translation>A、保管</translation>
    </message>
    <message>
        <source>B, now</source>
        <translation>B、現在</translation>
    </message>
    <message>
        <source>as POV-Ray</source>
        <translation>POV-Ray 風</translation>
    </message>
    <message>
        <source>Counting what each pixel takes…</source>
        <translation>各ピクセルの評価回数を数えています…</translation>
    </message>
</context>
<context>
    <name>isoscope::Viewport</name>
    <message>
        <source>Picture of the scene</source>
        <translation>シーンの画像</translation>
    </message>
    <message>
        <source>Arrow keys turn the view, Shift and arrow keys shift it, plus and minus zoom, Home resets; Alt and arrow keys move the divider of a split view</source>
        <translation>矢印キーでビューを回転、Shift と矢印キーで移動、+ と - でズーム、Home で元に戻す。Alt と矢印キーで分割ビューの境界を移動</translation>
    </message>
    <message>
        <source>Drag to turn, right-drag or Shift-drag to shift, wheel to zoom, double-click to reset, Ctrl-drag to take the picture elsewhere</source>
        <translation>ドラッグで回転、右ドラッグか Shift+ドラッグで移動、ホイールでズーム、ダブルクリックで元に戻す、Ctrl+ドラッグで画像を外へ</translation>
    </message>
    <message>
        <source>Nothing to see yet: the text has no object.
Type a formula, such as x*x + y*y + z*z - 1, or insert a function, to begin.</source>
        <translation>まだ見るものがありません。テキストにオブジェクトがありません。
x*x + y*y + z*z - 1 のような式を入力するか、関数を挿入して始めてください。</translation>
    </message>
</context>
<context>
    <name>isoscope::ViewportPanel</name>
    <message>
        <source>View tools</source>
        <translation>ビューのツール</translation>
    </message>
    <message>
        <source>More tools</source>
        <translation>その他のツール</translation>
    </message>
    <message>
        <source>State of the picture</source>
        <translation>画像の状態</translation>
    </message>
    <message>
        <source>How far the picture is, and the time since it began.</source>
        <translation>画像の進み具合と、開始からの時間。</translation>
    </message>
    <message>
        <source>Cost of the picture</source>
        <translation>画像のコスト</translation>
    </message>
    <message>
        <source>How much of the picture is proven to be right, and what it cost. Exact pictures are proven pixel by pixel, by the certified root finder; the cost is told in rays and in evaluations of functions.</source>
        <translation>画像のうち正しいと証明された割合とそのコスト。正確な画像は保証付き求根法によりピクセルごとに証明されます。コストはレイの数と関数の評価回数で示します。</translation>
    </message>
    <message>
        <source>No picture yet</source>
        <translation>画像はまだありません</translation>
    </message>
    <message>
        <source>Pass %1 of %2, %3 s</source>
        <translation>パス %1 / %2、%3 秒</translation>
    </message>
    <message>
        <source>Stopped after pass %1 of %2, %3 s</source>
        <translation>パス %1 / %2 の後で停止、%3 秒</translation>
    </message>
    <message>
        <source>Finished in %1 s, %2 × %3</source>
        <translation>%1 秒で完了、%2 × %3</translation>
    </message>
    <message>
        <source>%1 rays, %2 evaluations</source>
        <translation>レイ %1、評価 %2</translation>
    </message>
    <message>
        <source>Nothing was there to prove</source>
        <translation>証明するものはありませんでした</translation>
    </message>
</context>
<context>
    <name>isoscope::VtkPanel</name>
    <message>
        <source>This panel cannot be drawn: %1.</source>
        <translation>このパネルは描けません: %1。</translation>
    </message>
</context>
<context>
    <name>isoscope::WhatsThis</name>
    <message>
        <source>&lt;p&gt;The level at which the surface lies: it is where the function has this value, and the solid is where the function is smaller.&lt;/p&gt;&lt;p&gt;&lt;b&gt;threshold&lt;/b&gt; is 0 where the text says nothing.&lt;/p&gt;</source>
        <translation>&lt;p&gt;曲面のあるレベル。関数がこの値を取る所が曲面で、より小さい所が立体です。&lt;/p&gt;&lt;p&gt;テキストに何もなければ &lt;b&gt;threshold&lt;/b&gt; は 0 です。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;How closely the place of the surface is found. Smaller is finer and takes longer; sheets thinner than this may be missed.&lt;/p&gt;&lt;p&gt;POV-Ray ends its search along a ray when the interval is shorter than &lt;b&gt;accuracy&lt;/b&gt;.&lt;/p&gt;</source>
        <translation>&lt;p&gt;曲面の位置をどれだけ細かく求めるか。小さいほど細かく、時間がかかります。これより薄い面は見落とされることがあります。&lt;/p&gt;&lt;p&gt;POV-Ray は区間が &lt;b&gt;accuracy&lt;/b&gt; より短くなるとレイに沿った探索を終えます。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;How steep POV-Ray takes the function to be. Too low leaves holes in its picture, too high makes it slow; the badge in the status line tells which, with proof.&lt;/p&gt;&lt;p&gt;The gradient of the function must nowhere in the container be longer than &lt;b&gt;max_gradient&lt;/b&gt;.&lt;/p&gt;</source>
        <translation>&lt;p&gt;POV-Ray が見なす関数の傾き。小さすぎると画像に穴が残り、大きすぎると遅くなります。どちらであるかは状態行のバッジが証明付きで示します。&lt;/p&gt;&lt;p&gt;関数の勾配の長さは、コンテナ内のどこでも &lt;b&gt;max_gradient&lt;/b&gt; を超えてはなりません。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Shows the surface as it is, without holes.&lt;/p&gt;&lt;p&gt;The certified root finder encloses the function along every ray and proves what it finds; it needs no max_gradient. Pixels that could not be proven are counted below the picture.&lt;/p&gt;</source>
        <translation>&lt;p&gt;曲面を穴なしでありのままに表示します。&lt;/p&gt;&lt;p&gt;保証付き求根法はすべてのレイに沿って関数を上下から囲み、見つけたものを証明します。max_gradient は不要です。証明できなかったピクセルの数は画像の下に示されます。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Shows what POV-Ray will draw, holes included.&lt;/p&gt;&lt;p&gt;POV-Ray&apos;s root finder trusts max_gradient and accuracy of the text; where the function is steeper than max_gradient it may step over the surface.&lt;/p&gt;</source>
        <translation>&lt;p&gt;POV-Ray が描くものを、穴も含めて表示します。&lt;/p&gt;&lt;p&gt;POV-Ray の求根法はテキストの max_gradient と accuracy を信じます。関数が max_gradient より急な所では曲面を飛び越えることがあります。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Marks the pixels that are not proven to be right; mostly there are none.&lt;/p&gt;&lt;p&gt;The certified root finder leaves a pixel unproven when a root closer than accuracy/100 may hide there, when the ray took too many evaluations, or when the function has no known bounds.&lt;/p&gt;</source>
        <translation>&lt;p&gt;正しいと証明されていないピクセルに印を付けます。たいていは 1 つもありません。&lt;/p&gt;&lt;p&gt;保証付き求根法がピクセルを未証明とするのは、accuracy/100 より近い根が隠れうるとき、レイの評価が多すぎたとき、関数の上下界が不明のときです。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Shows where POV-Ray&apos;s picture would have holes, over the exact picture.&lt;/p&gt;&lt;p&gt;Both root finders are run; pixels are lost, gained, or found at a wrong place.&lt;/p&gt;</source>
        <translation>&lt;p&gt;POV-Ray の画像に穴ができる所を、正確な画像の上に示します。&lt;/p&gt;&lt;p&gt;両方の求根法を実行します。ピクセルは消失、余分、位置違いのいずれかです。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Shows both pictures side by side: POV-Ray&apos;s at the left, the exact one at the right. Drag the divider.&lt;/p&gt;</source>
        <translation>&lt;p&gt;2 つの画像を並べて表示します。左は POV-Ray、右は正確な画像です。境界をドラッグできます。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Shows only what POV-Ray&apos;s picture gets wrong, without the picture itself.&lt;/p&gt;</source>
        <translation>&lt;p&gt;POV-Ray の画像の誤りだけを、画像なしで表示します。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Colours the surface by how steep the function is there; red is too steep for POV-Ray.&lt;/p&gt;&lt;p&gt;The colour is the length of the gradient as a share of max_gradient.&lt;/p&gt;</source>
        <translation>&lt;p&gt;関数の傾きによって曲面に色を付けます。赤は POV-Ray には急すぎる所です。&lt;/p&gt;&lt;p&gt;色は max_gradient に対する勾配の長さの割合です。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Has the POV-Ray that is installed draw the text, in a folder of its own, and shows its picture left of a divider that can be dragged, the exact one right of it. It is drawn anew for every view that rests.&lt;/p&gt;</source>
        <translation>&lt;p&gt;インストール済みの POV-Ray が専用のフォルダでテキストを描き、その画像をドラッグできる境界の左に、正確な画像を右に表示します。ビューが静止するたびに描き直します。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Has the POV-Ray that is installed draw the text and marks each pixel that differs from the exact picture by its cause: holes, accuracy, jumps, outlines, and what is not shown here.&lt;/p&gt;</source>
        <translation>&lt;p&gt;インストール済みの POV-Ray がテキストを描き、正確な画像と異なる各ピクセルに、穴、accuracy、跳び、輪郭、ここで表示されないものという原因別の印を付けます。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Shows what you change beside what was.&lt;/p&gt;&lt;p&gt;The scene is kept as it is at this moment (A); from now on it is drawn left of the divider, and the present one (B) right of it: other values, or another function. Choose it again to keep the present scene instead.&lt;/p&gt;</source>
        <translation>&lt;p&gt;変更を以前のものと並べて表示します。&lt;/p&gt;&lt;p&gt;シーンはこの時点のまま (A) 保管されて境界の左に、別の値や別の関数にした現在のもの (B) は右に描かれます。再び選ぶと、現在のシーンを代わりに保管します。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Shows the picture alone, with nothing laid over it.&lt;/p&gt;</source>
        <translation>&lt;p&gt;何も重ねず、画像だけを表示します。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Click a pixel to see why it looks as it does: how the function runs along the line of sight, where the surface is met, and what POV-Ray stepped over.&lt;/p&gt;&lt;p&gt;The panel “Ray” charts the function over the distance along the &lt;b&gt;ray&lt;/b&gt;.&lt;/p&gt;</source>
        <translation>&lt;p&gt;ピクセルをクリックすると、なぜそう見えるかがわかります。視線に沿った関数の様子、曲面に当たる所、POV-Ray が飛び越えた所です。&lt;/p&gt;&lt;p&gt;パネル「レイ」は &lt;b&gt;レイ&lt;/b&gt; に沿った距離に対する関数のグラフです。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Shows where the object is cut, and lets you drag the cut.&lt;/p&gt;&lt;p&gt;The &lt;b&gt;cross-section&lt;/b&gt; shows the values of the function on that plane.&lt;/p&gt;</source>
        <translation>&lt;p&gt;オブジェクトがどこで切られるかを示し、切断をドラッグできます。&lt;/p&gt;&lt;p&gt;&lt;b&gt;断面&lt;/b&gt; はその平面上の関数の値を示します。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Shows what each pixel takes in evaluations of the function, the brighter the more, in the colour of the cause: empty space in the container, a field that is steep elsewhere, rays along the surface, places where the function jumps.&lt;/p&gt;&lt;p&gt;It counts for the root finder of the picture, exact or as POV-Ray.&lt;/p&gt;</source>
        <translation>&lt;p&gt;各ピクセルにかかる関数の評価回数を、多いほど明るく、原因の色で示します。原因は、コンテナ内の空き空間、ほかの場所で急な場、曲面に沿うレイ、関数が跳ぶ所です。&lt;/p&gt;&lt;p&gt;正確または POV-Ray 風のうち、画像に使う求根法で数えます。&lt;/p&gt;</translation>
    </message>
</context>
</TS>
