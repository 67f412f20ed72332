import { checkFieldValue, FieldError, type FieldTable, type FieldValue } from '@farol/editing/fields';
import type { AssetLibrary, Scene } from '@farol/engine';

/** Options of every scene builder, besides its own parameters. */
export interface SceneBuildOptions {
  /** Library of meshes and textures; the scene makes one of its own when absent. */
  assets?: AssetLibrary;
  /** Seed of positions and colours; 1 when absent. */
  seed?: number;
  /**
   * Whether meshes cast and receive shadows, and directional lights, spot lights and a few point lights cast them.
   * False when absent.
   */
  shadows?: boolean;
}

/** Values of the parameters of a demo scene, by name. */
export type SceneParameters = Readonly<Record<string, FieldValue>>;

/** A demo scene with its parameters, as listed in menus. */
export interface SceneDefinition {
  /** Key of the scene in `scenes` and in URLs. */
  readonly name: string;
  readonly label: string;
  readonly help: string;
  readonly parameters: FieldTable;
  /** Values of parameters for the scene's sample in the editor. */
  readonly sample: SceneParameters;
  /**
   * Makes the scene; equal parameters give equal scenes.
   * @param params - values of parameters; absent ones have their defaults
   * @throws FieldError for a parameter that is unknown or out of range
   */
  build(params?: SceneParameters, assets?: AssetLibrary): Promise<Scene>;
}

/** Defines a scene; `make` gets all parameters, checked. */
export function defineScene<const F extends FieldTable>(definition: {
  name: string;
  label: string;
  help: string;
  parameters: F;
  sample: SceneParameters;
  make(get: <K extends keyof F & string>(name: K) => FieldValue, assets?: AssetLibrary): Promise<Scene>;
}): SceneDefinition {
  const { name, label, help, parameters, sample, make } = definition;
  const build = async (params: SceneParameters = {}, assets?: AssetLibrary): Promise<Scene> => {
    for (const key of Object.keys(params)) {
      const problem = Object.hasOwn(parameters, key)
        ? checkFieldValue(parameters[key], params[key])
        : `is unknown; the parameters are ${Object.keys(parameters).join(', ')}`;
      if (problem) throw new FieldError(name, key, problem);
    }
    return make((key) => params[key] ?? parameters[key].default, assets);
  };
  return { name, label, help, parameters, sample, build };
}
