import { checkFieldValue, FieldError, type FieldTable, type FieldValue } from '@farol/editing/fields';
import type { AssetLibrary, Scene } from '@farol/engine';

/** Options that every builder of a scene takes besides its own parameters. */
export interface SceneBuildOptions {
  /** Library of meshes and textures; the scene makes one of its own when absent. */
  assets?: AssetLibrary;
  /** Another seed, other places and colours; 1 when absent. */
  seed?: number;
  /**
   * Meshes throw and receive shadows; directional lights, spot lights and a few point lights throw them. None when
   * absent.
   */
  shadows?: boolean;
}

/** Values of the parameters of a demo scene, by name. */
export type SceneParameters = Readonly<Record<string, FieldValue>>;

/** A demo scene with its parameters, as menus of scenes offer it. */
export interface SceneDefinition {
  /** Key in `scenes` and in URLs. */
  readonly name: string;
  readonly label: string;
  readonly help: string;
  readonly parameters: FieldTable;
  /** Values of parameters with which an editor shows it as a sample. */
  readonly sample: SceneParameters;
  /**
   * Makes the scene; the same one for the same parameters.
   * @param params - values of the parameters; the default for those that are absent
   * @throws FieldError for a parameter that is unknown or out of range
   */
  build(params?: SceneParameters, assets?: AssetLibrary): Promise<Scene>;
}

/** Describes a scene; `make` gets every parameter, checked. */
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
