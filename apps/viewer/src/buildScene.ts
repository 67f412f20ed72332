import type { AssetLibrary, Scene } from '@farol/engine';
import type { FieldValue } from '@farol/engine/fields';
import { scenes, sponza } from '@farol/scenes';
import type { Group, WebGLRenderer } from 'three';
import { fetchModel } from './model/fetchModel';

/** Address of the real Sponza, or null; set by vite.config.ts. */
declare const SPONZA_URL: string | null;

let realSponza: Promise<Group> | null = null;

/**
 * Makes one of the engine's scenes. The real Sponza replaces the atrium if its glTF is available.
 *
 * @throws Error (as a rejection) when there is no such scene, a parameter is wrong or a file cannot be read
 */
export async function buildScene(
  name: string,
  parameters: Record<string, FieldValue>,
  assets: AssetLibrary,
  renderer: WebGLRenderer,
): Promise<Scene> {
  if (!Object.hasOwn(scenes, name)) {
    throw new Error(`it is unknown: choose one of ${Object.keys(scenes).join(', ')}.`);
  }
  const { build, parameters: fields } = scenes[name];
  if (name !== 'sponza' || SPONZA_URL === null) return build(parameters, assets);
  realSponza ??= fetchModel(SPONZA_URL, renderer);
  const { lights = fields.lights.default, seed = fields.seed.default } = parameters;
  return sponza(Number(lights), { model: await realSponza, seed: Number(seed), assets });
}
