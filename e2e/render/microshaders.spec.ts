import { readFileSync } from 'node:fs';
import { expect, test } from '../support/benchTest';

const thesis = readFileSync(new URL('../../public/microshaders/thesis.xml', import.meta.url), 'utf8');

test("the thesis's file makes a shader for each kind of light", async ({ benchPage: page }) => {
  const programs = await page.evaluate(async () => {
    const { authoring } = window.testPage;
    const gl = new OffscreenCanvas(1, 1).getContext('webgl2')!;
    const registry = new authoring.MicroShaderRegistry(null, { compiler: new authoring.WebGLShaderCompiler(gl) });
    const made: [string, boolean, number][] = [];
    for (const light of ['light_directional', 'light_point', 'light_spot']) {
      const fragment = ['surface', 'light', light, 'phong', 'phong_output'];
      const shader = await registry.getShader(light, ['transform'], fragment, './microshaders/thesis.xml');
      made.push([light, gl.isProgram(shader.program), gl.getError()]);
    }
    return made;
  });
  expect(programs).toEqual([
    ['light_directional', true, 0],
    ['light_point', true, 0],
    ['light_spot', true, 0],
  ]);
});

test('a broken live edit is refused with chunk and line, and the last good program stays', async ({
  benchPage: page,
}) => {
  const result = await page.evaluate(() => {
    const { authoring } = window.testPage;
    const gl = new OffscreenCanvas(1, 1).getContext('webgl2')!;
    const registry = new authoring.MicroShaderRegistry(null, { compiler: new authoring.WebGLShaderCompiler(gl) });
    registry.loadGLSL(
      'fullscreen',
      '//# main\ngl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);',
    );
    registry.loadGLSL(
      'colour',
      '// A colour.\n// Farol\n#include <common>\nvec3 colour() { return vec3(1.0, 0.0, 0.0); }',
    );
    registry.loadGLSL('paint', '#include "colour"\n//# main\ngl_FragColor = vec4(colour(), 1.0);');
    const shader = registry.getShader('painted', ['fullscreen'], ['paint']);
    const pixel = () => {
      gl.useProgram(shader.program);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
      const pixels = new Uint8Array(4);
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
      return [...pixels];
    };
    const red = pixel();
    let error: unknown;
    try {
      registry.replace(
        'colour',
        '// A colour.\n// Farol\n#include <common>\nvec3 colour() {\n  return vec3(green, 0.0);\n}',
      );
    } catch (caught) {
      error = caught;
    }
    const refused = error instanceof authoring.MicroShaderCompileError ? error.entries : error;
    const still = pixel();
    registry.replace('colour', 'vec3 colour() { return vec3(0.0, 1.0, 0.0); }');
    return { red, refused, still, green: pixel(), revision: shader.revision, error: gl.getError() };
  });
  expect(result).toMatchObject({
    red: [255, 0, 0, 255],
    still: [255, 0, 0, 255],
    green: [0, 255, 0, 255],
    revision: 1,
    error: 0,
  });
  expect((result.refused as object[])[0]).toMatchObject({ chunk: 'colour', line: 5, text: 'return vec3(green, 0.0);' });
});

test("the XML reader agrees with the browser's own, in what it reads and in what it refuses", async ({
  benchPage: page,
}) => {
  const disagreements = await page.evaluate((file) => {
    const { authoring } = window.testPage;
    const mine = (text: string) => {
      try {
        const parts = authoring.parseMicroShaderXML(text, 'f').map(({ name, header, main }) => [name, header, main]);
        return JSON.stringify(parts);
      } catch {
        return 'refused';
      }
    };
    const theirs = (text: string) => {
      const document = new DOMParser().parseFromString(text, 'text/xml');
      if (document.querySelector('parsererror')) return 'refused';
      const text0 = (parent: Element, name: string) => parent.querySelector(name)?.textContent ?? '';
      return JSON.stringify(
        [...document.documentElement.children].map((e) => [
          e.getAttribute('name'),
          text0(e, 'header'),
          text0(e, 'main'),
        ]),
      );
    };
    // every text that is the file less a piece, or with a piece that may or may not be allowed there
    const texts = [
      ['', file],
      ['CRLF', file.replaceAll('\n', '\r\n')],
      ['BOM', `\uFEFF${file}`],
    ];
    for (let i = 0; i < 120; i++) {
      const at = Math.floor((i * file.length) / 120);
      const [before, after] = [file.slice(0, at), file.slice(at)];
      for (const piece of ['<', '>', '&', '&lt;', '&#65;', ']]>', '<!-- x -->', '"', '</main>', '<![CDATA[x]]>']) {
        texts.push([`${before.slice(-20)}${piece}${after.slice(0, 20)}`, before + piece + after]);
      }
      texts.push([`${before.slice(-20)} less ${after.slice(0, 20)}`, before + after.slice(1)]);
      texts.push([before.slice(-20), before]);
    }
    const differ = texts.filter(([, text]) => mine(text) !== theirs(text));
    // what is XML, but not of this file's form, is refused by ours alone
    const wrong = differ.filter(([, text]) => mine(text) !== 'refused').map(([where]) => where);
    return { compared: texts.length, agreed: texts.length - differ.length, wrong };
  }, thesis);
  expect(disagreements.wrong).toEqual([]);
  expect(disagreements.agreed).toBeGreaterThan(disagreements.compared * 0.8);
});
