import { ShaderChunk, type WebGLRenderer } from 'three';
import { MicroShaderCompileError } from '../microshaders/MicroShaderCompileError';
import type { MicroShaderRegistry } from '../microshaders/MicroShaderRegistry';

/** Entry of `WebGLRenderer.info.programs`. */
interface Program {
  readonly name: string;
  readonly vertexShader: WebGLShader;
  readonly fragmentShader: WebGLShader;
}

/** Matches the line in which a material lists the names replaced in its program: 'old=new', in order. */
const NAMES = /^\/\/ names (.+)$/m;

const THREE_INCLUDE = /^[ \t]*#include +<([\w./]+)>/gm;

/**
 * Test-compiles a replaced microshader in every existing program that contains it, before it takes effect.
 * @param names - the replaced chunk and its dependants; the registry already returns their new text
 * @throws MicroShaderCompileError with chunk and line, when one of them does not compile
 */
export function checkLiveEdit(webgl: WebGLRenderer, registry: MicroShaderRegistry, names: readonly string[]): void {
  const gl = webgl.getContext() as WebGL2RenderingContext;
  // chunks replaced earlier are checked too, since programs not drawn since still have their old text
  const edited = registry.names().filter((name) => registry.get(name) !== registry.original(name));
  const all = [...new Set([...edited, ...names])];
  for (const program of (webgl.info.programs ?? []) as unknown as Program[]) {
    for (const stage of ['vertex', 'fragment'] as const) {
      const before = gl.getShaderSource(program[`${stage}Shader`]) ?? '';
      if (!names.some((name) => before.includes(`// <${name}>`))) continue;
      const after = withNewText(before, registry, all);
      if (after === before) continue;
      const shader = gl.createShader(stage === 'vertex' ? gl.VERTEX_SHADER : gl.FRAGMENT_SHADER);
      if (shader === null) return; // the context is lost: three recompiles once it is restored
      gl.shaderSource(shader, after);
      gl.compileShader(shader);
      const compiled = gl.getShaderParameter(shader, gl.COMPILE_STATUS) as boolean;
      const log = gl.getShaderInfoLog(shader) ?? '';
      gl.deleteShader(shader);
      if (!compiled) throw new MicroShaderCompileError(program.name, stage, log, after);
    }
  }
}

/** The source of a program, in which each named chunk (`// <name>` to `// </name>`) has the registry's current text. */
function withNewText(source: string, registry: MicroShaderRegistry, names: readonly string[]): string {
  let text = source;
  for (const name of names) {
    if (!source.includes(`// <${name}>`)) continue;
    const isOfVertices = registry.get(name)?.stage === 'vertex';
    let composed = isOfVertices
      ? registry.compose([name], []).vertexShader
      : registry.compose([], [name]).fragmentShader;
    for (const pair of NAMES.exec(source)?.[1].split(' ') ?? []) {
      const [old, other] = pair.split('=');
      composed = composed.replaceAll(old, other);
    }
    const [headers, main = ''] = composed.split(/^void main\(\) \{$/m);
    const [beforeMain, ...rest] = text.split(/^void main\(\) \{$/m);
    text = [replaceFrames(beforeMain, headers, name), ...rest.map((part) => replaceFrames(part, main, name))].join(
      'void main() {',
    );
  }
  return text;
}

const FRAMES = /^\/\/ <([^/>][^>]*)>(?: \d+)?\n[^]*?^\/\/ <\/\1>\n/gm;

/** Replaces the lines `// <name>` to `// </name>` by those in `composed`; puts those of its dependencies before them. */
function replaceFrames(text: string, composed: string, name: string): string {
  const frames = framesOf(composed);
  const place = framesOf(text).get(name);
  if (!frames.has(name) || place === undefined) return text;
  const at = text.indexOf(place);
  const before = text.slice(0, at);
  let after = text.slice(at + place.length);
  for (const other of framesOf(before).keys()) frames.delete(other);
  for (const [other, frame] of framesOf(after)) if (frames.has(other)) after = after.replace(frame, '');
  return before + resolveThree([...frames.values()].join('')) + after;
}

function framesOf(text: string): Map<string, string> {
  return new Map([...text.matchAll(FRAMES)].map((match) => [match[1], match[0]]));
}

function resolveThree(text: string): string {
  return text.replace(THREE_INCLUDE, (line, name: string) =>
    Object.hasOwn(ShaderChunk, name) ? resolveThree(ShaderChunk[name as keyof typeof ShaderChunk]) : line,
  );
}
