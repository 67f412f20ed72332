import { MicroShaderCompileError } from '../microshaders';
import { describe, expect, it } from 'vitest';
import { parseSurface } from './parseSurface';

const parse = (text: string) => parseSurface('test', text, 'p_');
const HOOK = 'void surface(inout SurfaceData s) {}';

/** The line and message of the error that a text gives. */
function problemOf(text: string): [number, string] {
  try {
    parse(text);
  } catch (error) {
    if (error instanceof MicroShaderCompileError) return [error.entries[0].line, error.entries[0].message];
  }
  throw new Error(`no error: ${text}`);
}

describe('declared uniforms', () => {
  it('have type, default, range, step and label of their comment', () => {
    const { uniforms } = parse(`uniform float height; // = 0.2 [0, 1, 0.01] Height of the waves (m)
uniform highp float plain;
uniform int count; // = 3 [1, 8]
uniform bool isOn; // = true On
uniform vec2 way; // = 1, -0.5 Way
uniform vec3 axis; // = vec3(0.0, 1.0, 0.0)
uniform vec3 rim; // = #ff0000 Rim
uniform vec3 baseColor; // = 0.5, 0.25, 1
uniform vec4 four; // = 2
uniform sampler2D pattern; // Pattern
  uniform float a, b; // only words
uniform mat4 modelMatrix;
${HOOK}`);
    expect(uniforms).toEqual([
      {
        name: 'height',
        type: 'float',
        isColor: false,
        default: 0.2,
        min: 0,
        max: 1,
        step: 0.01,
        label: 'Height of the waves (m)',
        line: 1,
      },
      { name: 'plain', type: 'float', isColor: false, default: 0, label: 'plain', line: 2 },
      { name: 'count', type: 'int', isColor: false, default: 3, min: 1, max: 8, label: 'count', line: 3 },
      { name: 'isOn', type: 'bool', isColor: false, default: true, label: 'On', line: 4 },
      { name: 'way', type: 'vec2', isColor: false, default: [1, -0.5], label: 'Way', line: 5 },
      { name: 'axis', type: 'vec3', isColor: false, default: [0, 1, 0], label: 'axis', line: 6 },
      { name: 'rim', type: 'vec3', isColor: true, default: [1, 0, 0], label: 'Rim', line: 7 },
      { name: 'baseColor', type: 'vec3', isColor: true, default: [0.5, 0.25, 1], label: 'baseColor', line: 8 },
      { name: 'four', type: 'vec4', isColor: false, default: [2, 2, 2, 2], label: 'four', line: 9 },
      { name: 'pattern', type: 'sampler2D', isColor: false, default: null, label: 'Pattern', line: 10 },
      { name: 'a', type: 'float', isColor: false, default: 0, label: 'only words', line: 11 },
      { name: 'b', type: 'float', isColor: false, default: 0, label: 'only words', line: 11 },
    ]);
  });

  it.each([
    [`\nuniform mat4 m;\n${HOOK}`, 2, '"mat4" uniforms cannot be set'],
    [`uniform float a;\nuniform float a;\n${HOOK}`, 2, 'a second uniform "a"'],
    [`uniform bool a; // = 1\n${HOOK}`, 1, 'the default of "a" is true or false'],
    [`uniform vec3 a; // = 1, 2\n${HOOK}`, 1, 'the default of "a" is 3 numbers'],
    [`uniform float a; // = 1 [2, 1]\n${HOOK}`, 1, 'the range of "a" ends before it begins'],
    ['float a;', 1, 'write void surface(inout SurfaceData s)'],
    ['\nvoid surface(SurfaceData s) {}', 2, 'write void surface(inout SurfaceData s)'],
    [`${HOOK}\nvoid main() {}`, 2, 'no main()'],
  ])('refuses %j', (text, line, message) => {
    const [at, said] = problemOf(text);
    expect(at).toBe(line);
    expect(said).toContain(message);
  });
});

describe('the GLSL of a stage', () => {
  const text = `#include "noise"
uniform float height;
#define HALF 0.5
struct Ring { float height; };
const float PI2 = 6.28, TAU[2] = float[2](1.0, 2.0);
float wave(float x) {
  return sin(x * PI2) * height * HALF; // height
}
void displace(inout VertexData v) {
  v.positionOS.y += wave(v.positionOS.x) * v.time;
} float after;
void surface(inout SurfaceData s) { if (s.height > height) { discard; } s.color *= wave(1.0) + TAU[0]; }`;
  const parsed = parse(text);

  it('has its own names after the prefix, members and includes as they are, and no line moved', () => {
    const lines = parsed.fragment.split('\n');
    expect(lines[0]).toBe('#include "noise"');
    expect(lines[1]).toBe('uniform float p_height;');
    expect(lines[2]).toBe('#define p_HALF 0.5');
    expect(lines[4]).toBe('const float p_PI2 = 6.28, p_TAU[2] = float[2](1.0, 2.0);');
    expect(lines[6]).toContain('sin(x * p_PI2) * p_height * p_HALF;');
    expect(lines[11]).toContain('(s.height > p_height)');
    expect(lines[11]).toContain('p_wave(1.0) + p_TAU[0]');
  });

  it('has only the hook of the stage, and an empty one where the text has none', () => {
    expect(parsed.fragment.split('\n').slice(8, 11)).toEqual(['', '', ' float p_after;']);
    expect(parsed.vertex.split('\n').slice(8, 10)).toEqual([
      'void p_displace(inout VertexData v) {',
      '  v.positionOS.y += p_wave(v.positionOS.x) * v.time;',
    ]);
    expect(parsed.vertex.split('\n')[11]).toBe('');
    expect(parse(HOOK).vertex).toBe('\nvoid p_displace(inout VertexData data) {}');
  });

  it('says what it does', () => {
    expect(parsed).toMatchObject({
      paints: true,
      displaces: true,
      discards: true,
      paintsByTime: false,
      movesByTime: true,
    });
    expect(parse(HOOK)).toMatchObject({ paints: true, displaces: false, discards: false, movesByTime: false });
    expect(parse('void displace(inout VertexData v) { }')).toMatchObject({ paints: false, displaces: false });
    expect(parse('void surface(inout SurfaceData s) { s.opacity = s.time; }')).toMatchObject({
      discards: true,
      paintsByTime: true,
      movesByTime: true,
    });
  });

  it.each([
    ['s.opacity = 0.5;', true],
    ['s.opacity *= 0.5;', true],
    ['s.opacity-=0.5;', true],
    ['s.opacity += 0.5;', true],
    ['s.opacity /= 2.0;', true],
    ['discard;', true],
    ['if (s.opacity == 1.0) s.color *= 2.0;', false],
    ['s.color *= s.opacity;', false],
    ['// s.opacity = 0.5; discard;', false],
  ])('may leave pixels out by `%s`: %s', (line, discards) => {
    expect(parse(`void surface(inout SurfaceData s) {\n${line}\n}`).discards).toBe(discards);
  });
});

describe('a declared reach', () => {
  const text = (reach: string) => `uniform float height;\nuniform int count;\nuniform vec2 way;\n${reach}\n${HOOK}`;

  it('is a sum of products of numbers and uniforms', () => {
    expect(parse(text('')).reach).toBe(null);
    expect(parse(text('// reach: 0.5')).reach).toEqual([{ factor: 0.5, names: [] }]);
    expect(parse(text('  // reach : 1e-1 + 2 * height*count')).reach).toEqual([
      { factor: 0.1, names: [] },
      { factor: 2, names: ['height', 'count'] },
    ]);
    expect(parse(text('// reach: 2 * height * 0.25')).reach).toEqual([{ factor: 0.5, names: ['height'] }]);
  });

  it.each(['// reach: depth', '// reach: way', '// reach: 1 +', '// reach: sin(height)'])(
    '%s is refused with its line',
    (reach) => {
      const [line, message] = problemOf(text(reach));
      expect(line).toBe(4);
      expect(message).toContain('// reach: 0.1 + 2 * height');
    },
  );
});
