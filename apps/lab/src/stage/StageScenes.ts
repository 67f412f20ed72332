import { AssetLibrary, builtinComponents, ComponentRegistry, type Scene } from '@farol/engine';
import { deserialize, readSceneFile } from '@farol/engine/files';
import { scenes } from '@farol/scenes';
import { type Texture, WebGLRenderer } from 'three';
import type { LabCase } from '../plan/LabPlan';
import { buildStageScene } from './buildStageScene';
import { lightParameters } from './lightChoice';
import { loseContext } from './loseContext';
import type { StageScene } from './StageScene';
import { type StageTemplate, takeApart } from './StageTemplate';

/** A competitor's scene with its GPU resources, which `dispose` frees. */
export type OwnedScene = StageScene & { dispose(): void };

export interface StageScenesOptions {
  /** Creates the renderer whose device decodes compressed textures of `own`; null for none. Default a new one. */
  readonly makeRenderer?: () => WebGLRenderer | null;
}

/** Creates the scenes of cases. Meshes and textures are shared, and the template of the last case is cached. */
export class StageScenes {
  private readonly assets = new AssetLibrary();
  private ownFile: Uint8Array | null = null;
  private last: { readonly key: string; readonly template: Promise<StageTemplate> } | null = null;

  private readonly makeRenderer: () => WebGLRenderer | null;

  constructor({ makeRenderer = makeOwnRenderer }: StageScenesOptions = {}) {
    this.makeRenderer = makeRenderer;
  }

  /** Sets the scene `own`: bytes of a scene file of the engine. */
  setOwn(file: Uint8Array): void {
    this.ownFile = file;
    if (this.last?.key.startsWith('own ')) this.last = null;
  }

  /**
   * Creates a competitor's scene for a case; equal for all competitors.
   *
   * @throws Error (as a rejection) that names an unknown scene, a parameter out of range, or what is wrong with `own`
   */
  async build(labCase: LabCase): Promise<OwnedScene> {
    const profiles = labCase.lightKind === 'profiles' ? await this.profiles() : [];
    return buildStageScene(labCase, await this.templateOf(labCase), profiles);
  }

  private profiles(): Promise<Texture[]> {
    const names = ['profile/downlight', 'profile/wall-washer', 'profile/street-light'];
    return Promise.all(
      names.map(async (name) => {
        await this.assets.load(name);
        return this.assets.profile(name).texture;
      }),
    );
  }

  private templateOf(labCase: LabCase): Promise<StageTemplate> {
    const { scene, lights, width, height } = labCase;
    // the key is without kind of lights and shading, which are set on the copies of the template
    const key = `${scene.name} ${JSON.stringify([scene.parameters, lights, width, height])}`;
    if (this.last?.key === key) return this.last.template;
    const template = this.makeTemplate(labCase);
    this.last = { key, template };
    template.catch(() => {
      if (this.last?.key === key) this.last = null;
    });
    return template;
  }

  private async makeTemplate({ scene, lights, width, height }: LabCase): Promise<StageTemplate> {
    const moves = scene.name !== 'own';
    const made = moves ? await this.demoScene(scene, lights ?? 0) : await this.ownScene();
    return takeApart(made, { width, height }, moves);
  }

  private async demoScene({ name, parameters }: LabCase['scene'], lights: number): Promise<Scene> {
    const definition = scenes[name];
    if (!definition) {
      throw new Error(`There is no scene ‘${name}’: choose one of ${Object.keys(scenes).join(', ')} or own.`);
    }
    const known = Object.keys(definition.parameters);
    return definition.build({ ...parameters, ...lightParameters(known, lights) }, this.assets);
  }

  private async ownScene(): Promise<Scene> {
    if (!this.ownFile) {
      throw new Error('No scene was handed over: choose “Measure this scene” in the editor or the viewer.');
    }
    const { text, fileOf } = await readSceneFile(this.ownFile, () => true);
    // components of plugins are kept as data; nothing is fetched from other addresses
    const registry = new ComponentRegistry(builtinComponents.types.values(), { keepUnknown: true });
    // this renderer decodes compressed textures to a format that the device supports
    const renderer = this.makeRenderer();
    try {
      return await deserialize(text, {
        assets: new AssetLibrary(renderer ? { renderer } : {}),
        registry,
        fileOf,
        mayFetch: () => false,
      });
    } finally {
      if (renderer) {
        loseContext(renderer.getContext() as WebGL2RenderingContext);
        renderer.dispose();
      }
    }
  }
}

const makeOwnRenderer = (): WebGLRenderer => new WebGLRenderer({ canvas: document.createElement('canvas') });
