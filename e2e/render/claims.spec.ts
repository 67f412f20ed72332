import { readdirSync, readFileSync } from 'node:fs';
import { basename } from 'node:path';
import { expect, test } from '../support/benchTest';

/**
 * Evaluates the claims of microshaders (`//? left == right`) on the GPU, a pixel each. Floats must agree to within 1e-5
 * of the greater of 1 and the right side, since drivers may round divisions and square roots; all else exactly.
 */
const texts = ['gbuffer', 'gpu', 'lighting', 'passes', 'techniques', 'effects'].flatMap((subject) => {
  const folder = new URL(`../../packages/renderer/src/${subject}/`, import.meta.url);
  return readdirSync(folder, { recursive: true, encoding: 'utf8' })
    .filter((path) => path.endsWith('.glsl'))
    .map((path) => [basename(path, '.glsl'), readFileSync(new URL(path, folder), 'utf8')] as const);
});

/** Texts that a text includes, directly or not. */
function includedBy(text: string): readonly (readonly [string, string])[] {
  const names = [...text.matchAll(/^#include "(\w+)"/gm)].map(([, name]) => name);
  return texts.filter(([name]) => names.includes(name)).flatMap((each) => [...includedBy(each[1]), each]);
}

/** Runs in the page. @returns what each claim came to */
function evaluateClaims([name, text, included]: readonly [string, string, ReturnType<typeof includedBy>]): {
  claim: string;
  holds: boolean;
}[] {
  const { authoring } = window.testPage;
  const registry = new authoring.MicroShaderRegistry();
  registry.add(authoring.builtinMicroShaders);
  for (const [other, source] of included) if (!registry.has(other)) registry.loadGLSL(other, source);
  if (registry.has(name)) registry.replace(name, text);
  else registry.loadGLSL(name, text);
  const claims = authoring.findClaims(text);
  if (claims.length === 0) return [];

  const near = ['float', 'vec2', 'vec3', 'vec4']
    .map((type) => `bool farol_claim(${type} a, ${type} b) { return distance(a, b) <= 1e-5 * max(1.0, length(b)); }`)
    .join('\n');
  const same = ['int', 'uint', 'bool', 'ivec2', 'ivec3', 'ivec4', 'uvec2', 'uvec4']
    .map((type) => `bool farol_claim(${type} a, ${type} b) { return a == b; }`)
    .join('\n');
  const cases = claims.map(
    ({ setup, left, right }, i) => `if (pixel == ${i}) { ${setup} holds = farol_claim(${left}, ${right}); }`,
  );
  // one for all of them: a browser takes the oldest of 16 contexts away
  const kept = window as { claimsCanvas?: OffscreenCanvas };
  const gl = (kept.claimsCanvas ??= new OffscreenCanvas(256, 1)).getContext('webgl2')!;
  const program = new authoring.WebGLShaderCompiler(gl).compile({
    name: `claims of ${name}`,
    vertexShader:
      'void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }',
    fragmentShader: `${registry.header([name])}${near}\n${same}
void main() {
  int pixel = int(gl_FragCoord.x);
  bool holds = false;
  ${cases.join('\n  ')}
  gl_FragColor = vec4(holds);
}`,
  });
  gl.useProgram(program);
  gl.drawArrays(gl.TRIANGLES, 0, 3);
  const pixels = new Uint8Array(claims.length * 4);
  gl.readPixels(0, 0, claims.length, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  const results = claims.map(({ line, text: claim }, i) => ({
    claim: `${name}.glsl:${line}: ${claim}`,
    holds: pixels[i * 4] === 255,
  }));
  return results;
}

test('every claim of the built-in microshaders holds', async ({ benchPage: page }) => {
  const results: { claim: string; holds: boolean }[] = [];
  for (const text of texts)
    results.push(...(await page.evaluate(evaluateClaims, [...text, includedBy(text[1])] as const)));
  expect(results.length, 'claims found').toBeGreaterThan(10);
  expect(results.filter(({ holds }) => !holds).map(({ claim }) => claim)).toEqual([]);
});

test('a claim that is wrong is seen to be', async ({ benchPage: page }) => {
  const results = await page.evaluate(evaluateClaims, [
    'trial',
    `//? twice(2.0) == 4.0
//? twice(2.0) == 4.001
//? vec2 a = vec2(1.0); a * twice(1.0) == vec2(2.0, 2.0)
//? vec2(twice(1.0)) == vec2(2.0, 3.0)
//? int(twice(2.0)) == 4
//? twice(1.0) > 1.0 == true
//? twice(1.0) / 0.0 - 1.0 / 0.0 == 0.0
float twice(float a) { return 2.0 * a; }`,
    [],
  ] as const);
  expect(results.map(({ holds }) => holds)).toEqual([true, false, true, false, true, true, false]);
});
