import type { Technique } from '@farol/renderer/authoring';
import { MicroShaderCompileError, type MicroShaderRegistry, WebGLShaderCompiler } from '@farol/renderer/microshaders';
import type { TechniqueName } from '@farol/renderer';
import { chunksOf, dryRun } from './dryRun';

/**
 * Compiles a microshader that no program contains, and its dependents, as a technique would, or alone.
 * @param registry - registry with the new text
 * @param texts - microshaders of the scene
 * @param user - technique that uses it; null when none does
 * @param techniques - all techniques, by name
 * @throws MicroShaderCompileError with microshader and line
 */
export function probeMicroShader(
  gl: WebGL2RenderingContext,
  registry: MicroShaderRegistry,
  texts: ReadonlyMap<string, string>,
  names: readonly string[],
  user: TechniqueName | null,
  techniques: Readonly<Record<string, Technique>>,
): void {
  if (user === null) {
    for (const name of names) if (registry.has(name)) compileAlone(gl, registry, name);
    return;
  }
  const tried = new Set<string>();
  for (const { stage, text } of dryRun(gl, { technique: user }, texts, techniques)) {
    if (tried.has(text) || !names.some((name) => chunksOf(text).has(name))) continue;
    tried.add(text);
    compileStage(gl, names[0], stage, text);
  }
}

/** @throws MicroShaderCompileError with microshader and line @param name - name of the changed microshader */
export function compileStage(
  gl: WebGL2RenderingContext,
  name: string,
  stage: 'vertex' | 'fragment',
  text: string,
): void {
  const shader = gl.createShader(stage === 'vertex' ? gl.VERTEX_SHADER : gl.FRAGMENT_SHADER);
  if (shader === null) return;
  gl.shaderSource(shader, text);
  gl.compileShader(shader);
  const isCompiled = gl.getShaderParameter(shader, gl.COMPILE_STATUS) as boolean;
  const log = gl.getShaderInfoLog(shader) ?? '';
  gl.deleteShader(shader);
  if (!isCompiled) throw new MicroShaderCompileError(name, stage, log, text);
}

/**
 * Compiles a microshader's header and its dependencies. Its main part may need microshaders that only a whole shader
 * has, and is left out.
 */
export function compileAlone(gl: WebGL2RenderingContext, registry: MicroShaderRegistry, name: string): void {
  const header = registry.header([name]);
  const stage = registry.get(name)?.stage === 'vertex' ? 'vertex' : 'fragment';
  const source = {
    name,
    vertexShader: `${stage === 'vertex' ? header : ''}void main() { gl_Position = vec4(0.0); }\n`,
    fragmentShader: `${stage === 'fragment' ? header : ''}void main() { gl_FragColor = vec4(0.0); }\n`,
  };
  const compiler = new WebGLShaderCompiler(gl);
  compiler.release(compiler.compile(source));
}
