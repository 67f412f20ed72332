import type { FarolRenderer, TechniqueName } from '@farol/renderer';
import type { MicroShaderRegistry } from '@farol/renderer/authoring';
import { chunksOf, dryRun } from './dryRun';
import { idle, VIEWS } from './MicroShaderUses';
import { compileAlone, compileStage } from './probeMicroShader';

/**
 * Compiles changed microshaders in every shader of every technique and debug view that contains them, or alone when
 * none does. Draws and changes nothing; yields to the page meanwhile.
 * @param farol - provides the techniques and the device
 * @param texts - microshaders of the scene with the changes
 * @param names - names of the changed ones
 * @throws MicroShaderCompileError (as a rejection) with microshader and line; Error naming unknown microshaders and
 *   cycles
 */
export async function checkMicroShaders(
  farol: FarolRenderer,
  texts: ReadonlyMap<string, string>,
  names: readonly string[],
): Promise<void> {
  const gl = farol.webgl.getContext() as WebGL2RenderingContext;
  const tried = new Set<string>();
  const compiledNames = new Set<string>();
  const run = (options: Parameters<typeof dryRun>[1], inspect: Parameters<typeof dryRun>[4]): void => {
    for (const { stage, text } of dryRun(gl, options, texts, farol.techniques, inspect)) {
      if (tried.has(text)) continue;
      tried.add(text);
      const chunks = chunksOf(text);
      const onTrial = names.filter((name) => chunks.has(name));
      for (const name of onTrial) compiledNames.add(name);
      if (onTrial.length > 0) compileStage(gl, onTrial[0], stage, text);
    }
  };
  const refuse = (_: MicroShaderRegistry, problems: readonly { readonly error: Error }[]): void => {
    if (problems.length > 0) throw problems[0].error;
  };
  for (const technique of (Object.keys(farol.techniques) as TechniqueName[]).filter((name) => name !== 'auto')) {
    await farol.techniques[technique].lazy?.load();
    await idle();
    run({ technique }, refuse);
  }
  for (const view of VIEWS) {
    await idle();
    run({ technique: 'clustered-forward', view }, refuse);
  }
  await idle();
  run({ technique: 'forward' }, (registry) => {
    for (const name of names) if (!compiledNames.has(name) && registry.has(name)) compileAlone(gl, registry, name);
  });
}
