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

/** A competitor's scene, which holds memory of the GPU until it is disposed. */
export type OwnedScene = StageScene & { dispose(): void };

export interface StageScenesOptions {
  /** Address of a mesh in place of the dragon that is made in code; null for none. */
  readonly dragon?: string | null;
  /** Renderer whose device says which compressed textures `own` is read to; null for none. Default one of its own. */
  readonly makeRenderer?: () => WebGLRenderer | null;
}

/** Makes the scenes of cases. Meshes and textures are made once, and the scene of the last case is kept. */
export class StageScenes {
  private readonly assets: AssetLibrary;
  private own: Uint8Array | null = null;
  private last: { readonly key: string; readonly template: Promise<StageTemplate> } | null = null;

  private readonly makeRenderer: () => WebGLRenderer | null;

  constructor({ dragon = null, makeRenderer = rendererOfItsOwn }: StageScenesOptions = {}) {
    this.makeRenderer = makeRenderer;
    this.assets = new AssetLibrary(dragon === null ? {} : { urls: { dragon } });
  }

  /** Takes the scene `own`: a scene file of the engine, as bytes. */
  setOwn(file: Uint8Array): void {
    this.own = file;
    if (this.last?.key.startsWith('own ')) this.last = null;
  }

  /**
   * A competitor's own scene of a case, the same for all of them.
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
    // the kind of the lights and the shading are the copies'
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
    if (!this.own) {
      throw new Error('No scene was handed over: choose “Measure this scene” in the editor or the viewer.');
    }
    const { text, fileOf } = await readSceneFile(this.own, () => true);
    // components of an editor's plugin stay data; nothing is fetched from elsewhere
    const registry = new ComponentRegistry(builtinComponents.types.values(), { keepUnknown: true });
    // compressed textures are read as the device takes them
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

const rendererOfItsOwn = (): WebGLRenderer => new WebGLRenderer({ canvas: document.createElement('canvas') });
