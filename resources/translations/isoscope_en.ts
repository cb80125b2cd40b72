<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>isoscope::DocumentController</name>
    <message numerus="yes">
        <source>%n unsaved texts were kept, the last one: %1, %2.</source>
        <translation>
            <numerusform>An unsaved text was kept: %1, %2.</numerusform>
            <numerusform>%n unsaved texts were kept, the last one: %1, %2.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>isoscope::HelpPanel</name>
    <message numerus="yes">
        <source>%n place(s)</source>
        <translation>
            <numerusform>%n place</numerusform>
            <numerusform>%n places</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>isoscope::NoticeBar</name>
    <message numerus="yes">
        <source>%n more</source>
        <comment>notices</comment>
        <translation>
            <numerusform>%n more</numerusform>
            <numerusform>%n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>isoscope::ParameterPanel</name>
    <message numerus="yes">
        <source>%n more number(s) are not shown; drag them in the text with Ctrl.</source>
        <translation>
            <numerusform>%n more number is not shown; drag it in the text with Ctrl.</numerusform>
            <numerusform>%n more numbers are not shown; drag them in the text with Ctrl.</numerusform>
        </translation>
    </message>
</context>
</TS>
