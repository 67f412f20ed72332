import { describe, expect, it } from 'vitest';
import { parseMicroShaderXML } from './parseMicroShaderXML';

const parse = (text: string) => parseMicroShaderXML(text, 'test.xml');

const inside = (text: string) => `<microshaders>\n${text}\n</microshaders>`;

const GOOD = `<?xml version="1.0" encoding="UTF-8"?>
<!-- the thesis's file -->
<microshaders>
  <microshader name="light" dependencies=" a  b" stage='fragment'>
    <header><![CDATA[
uniform float farDistance;
bool near(float d) { return d < farDistance && d > 0.0; }
]]></header>
    <maincode>if (1.0 &lt; 2.0 &#38;&#x26; true) color = <!-- red --><![CDATA[vec3(1.0);]]></maincode>
  </microshader>
  <microshader name="empty"/>
</microshaders>
`;

describe('parseMicroShaderXML', () => {
  it('reads names, dependencies, stage, header and main', () => {
    const [light, empty] = parse(GOOD);
    expect(light).toEqual({
      name: 'light',
      stage: 'fragment',
      dependencies: ['a', 'b'],
      header: '\nuniform float farDistance;\nbool near(float d) { return d < farDistance && d > 0.0; }\n',
      main: 'if (1.0 < 2.0 && true) color = vec3(1.0);',
      headerLine: 5,
      mainLine: 9,
    });
    expect(empty).toMatchObject({ name: 'empty', header: '', main: '', dependencies: [] });
  });

  it('reads the same whatever the line ends, with a byte order mark', () => {
    expect(parse(`\uFEFF${GOOD.replaceAll('\n', '\r\n')}`)).toEqual(parse(GOOD));
  });

  it('adds what the header includes to the dependencies', () => {
    const [chunk] = parse(
      '<microshaders><microshader name="a" dependencies="b"><header>\n#include "c"\n</header></microshader></microshaders>',
    );
    expect(chunk.dependencies).toEqual(['b', 'c']);
  });

  it.each([
    ['', /test\.xml:1: the file has no root element/],
    ['<shaders/>', /test\.xml:1: the root is <shaders>, not <microshaders>/],
    ['<!DOCTYPE html><html></html>', /test\.xml:1: "<!DOCTYPE html><html" is not XML/],
    ['<microshaders>\n<microshader name="a">', /test\.xml:2: <microshader> of line 2 is never closed/],
    ['<microshaders>\n</microshader>', /test\.xml:2: <\/microshader> does not close <microshaders> of line 1; write/],
    ['<microshaders/>\n<microshaders/>', /test\.xml:2: <microshaders> is a second root element/],
    ['<microshaders/>\nmore', /test\.xml:2: text is outside the root/],
    ['</microshaders>', /test\.xml:1: <\/microshaders> closes nothing/],
    [inside('<microshader/>'), /test\.xml:2: <microshader> without a name/],
    [inside('<microshader name=""/>'), /test\.xml:2: <microshader> without a name/],
    [inside('<microshader name="a b"/>'), /test\.xml:2: Microshader name "a b"/],
    [inside('<microshader name="a"/>\n<microshader name="a"/>'), /test\.xml:3: a second microshader named "a"/],
    [inside('<microshader name="a" name="b"/>'), /test\.xml:2: attribute "name" is twice/],
    [inside('<microshader name=a/>'), /test\.xml:2: "<microshader name=a\/>?" is not XML/],
    [inside('<microshader name="a" depends="b"/>'), /test\.xml:2: attribute "depends" is unknown/],
    [inside('<microshader name="a" stage="pixel"/>'), /test\.xml:2: Microshader "a" has the stage "pixel"/],
    [inside('<chunk name="a"/>'), /test\.xml:2: <chunk> where only <microshader>/],
    [inside('<microshader name="a">\n<code/></microshader>'), /test\.xml:3: <code> in microshader "a"/],
    [inside('<microshader name="a"><main/><main/></microshader>'), /test\.xml:2: a second <main> in microshader "a"/],
    [inside('<microshader name="a"><main/>\n<maincode/></microshader>'), /test\.xml:3: a second <maincode>/],
    [
      inside('<microshader name="a"><main>\ni < 2\n</main></microshader>'),
      /test\.xml:3: "< 2" is not XML; put GLSL into <!\[CDATA\[/,
    ],
    [inside('<microshader name="a"><main>\n\na &amp;& b</main></microshader>'), /test\.xml:4: "&" is not an entity/],
    ...['&nbsp;', '&constructor;', '&lt', '&ltx;', '&#0;', '&#x110000;', '&#65'].map((text): [string, RegExp] => [
      inside(`<microshader name="a"><main>${text}</main></microshader>`),
      new RegExp(`test\\.xml:2: "${text}" is not an entity`),
    ]),
    [inside('<microshader name="a"><main><b/></main></microshader>'), /test\.xml:2: <b> in the code of "a"/],
    [
      inside('<microshader name="a">float b;</microshader>'),
      /test\.xml:2: text directly inside <microshader>: "float b;"/,
    ],
    [inside('<microshader name="a"><main>]]></main></microshader>'), /test\.xml:2: "\]\]>" closes nothing/],
    [inside('<!-- a -- b -->'), /test\.xml:2: "<!-- a -- b -->" is not XML/],
  ])('refuses %j', (text, message) => {
    expect(() => parse(text)).toThrow(message);
  });
});
