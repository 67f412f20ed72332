import { Signal, t } from '@farol/editing';
import { ModelRenderer, ObjectRenderer, type Scene } from '@farol/engine';
import { type BakedLight, bakeSignature, bakeSources, writeBake } from '@farol/engine/bake';
import type { EditorApi } from '../../api/EditorApi';
import { freeAssetName } from '../../model/assetNames';
import { clearBakedLight, showBakedLight } from '../../model/bakeEdits';
import { bakeScene } from './bakeScene';
import { PictureBudget } from './PictureBudget';

type Baker = typeof import('@farol/bake');

export interface BakeState {
  /** Finished share of the bake, 0 to 1. */
  readonly share: number;
  readonly stage: 'unwrapping' | 'preparing' | 'tracing' | 'finishing' | 'saving';
  /** Number of paths traced per texel so far. */
  readonly samples: number;
  /** Estimated remaining time (s); null until there is an estimate. */
  readonly secondsLeft: number | null;
}

/** The baked light in use by a scene; null for none, and until it is loaded. */
export function bakedLightOf({ settings, assets }: Scene): BakedLight | null {
  const { bakedLight } = settings;
  return bakedLight !== null && assets.isReady('bake', bakedLight) ? assets.bake(bakedLight) : null;
}

/** Bakes the light of the document's scene; one bake at a time. */
export class LightBaker {
  /** Emits when a bake begins, progresses or ends. */
  readonly changed = new Signal();
  private running: { readonly abort: AbortController; state: BakeState } | null = null;

  constructor(
    private readonly editor: EditorApi,
    private readonly loadBaker: () => Promise<Baker> = () => import('@farol/bake'),
  ) {}

  /** Progress; null while no bake runs. */
  get state(): BakeState | null {
    return this.running?.state ?? null;
  }

  /** Whether the scene has changed since it was baked; false when nothing was baked. */
  get isOutOfDate(): boolean {
    const { scene, simulation } = this.editor.document;
    const baked = bakedLightOf(scene);
    return baked !== null && simulation.state === 'stopped' && baked.data.signature !== bakeSignature(scene);
  }

  /** Cancels the running bake, leaving the scene unchanged. */
  cancel(): void {
    this.running?.abort.abort(new DOMException('The bake was cancelled.', 'AbortError'));
  }

  /** Removes the baked light from the scene, as one undo step. */
  clear(): void {
    const { document, commands } = this.editor;
    if (document.scene.settings.bakedLight !== null) commands.run(clearBakedLight(document.scene));
  }

  /**
   * Bakes the scene and uses the result, as one undo step. Editing the scene meanwhile cancels the bake.
   * @throws Error (as a rejection) saying why the scene cannot be baked
   */
  async bake(): Promise<void> {
    if (this.running) return;
    const { document, notices } = this.editor;
    const { scene } = document;
    if (document.simulation.state !== 'stopped') throw new Error(t('The scene is playing: stop it to bake its light.'));
    const { meshes, lights } = bakeSources(scene);
    if (meshes.length === 0) throw new Error(t('Nothing is static: switch on Static for objects that do not move.'));
    if (lights.length === 0 && !scene.settings.bakeSky)
      notices.show('warning', t('No light is baked: set the mode of lights to Baked.'));
    const abort = new AbortController();
    this.running = { abort, state: { share: 0, stage: 'preparing', samples: 0, secondsLeft: null } };
    this.changed.emit();
    try {
      const blob = await this.run(scene, abort);
      abort.signal.throwIfAborted();
      await this.useBakedLight(scene, blob);
    } catch (error) {
      if (!abort.signal.aborted) throw error;
      const { reason } = abort.signal as { reason: Error };
      if (reason.name !== 'AbortError') notices.show('info', reason.message);
    } finally {
      this.running = null;
      this.changed.emit();
    }
  }

  /** Bakes the scene. @returns the file of the baked light */
  private async run(scene: Scene, abort: AbortController): Promise<Blob> {
    const { document, viewport, notices } = this.editor;
    const baker = await this.loadBaker();
    abort.signal.throwIfAborted();
    const resume = scene.baked.suspend();
    const stop = (): void => abort.abort(new Error(t('The scene was edited: the bake was stopped.')));
    const endings = [document.edited.subscribe(stop), document.simulation.changed.subscribe(stop)];
    const pictures = new PictureBudget();
    try {
      const data = await bakeScene(baker, viewport.webgl, scene, {
        signal: abort.signal,
        progressed: (progress) => {
          this.tell(progress);
          if (pictures.isDue(performance.now())) viewport.invalidate();
        },
        warned: (sentence) => notices.show('warning', sentence),
      });
      this.tell({ share: 1, stage: 'saving', samples: scene.settings.bakeSamples, secondsLeft: null });
      return new Blob([await writeBake(data)]);
    } finally {
      for (const end of endings) end();
      // the bake restored former meshes, which an edit may have replaced meanwhile: components set up theirs again
      if (document.scene === scene) {
        for (const type of [ObjectRenderer, ModelRenderer]) {
          for (const component of scene.componentsOf<ObjectRenderer | ModelRenderer>(type as typeof ObjectRenderer))
            component.onActiveChanged();
        }
      }
      resume();
      viewport.invalidate();
    }
  }

  private tell(state: BakeState): void {
    if (this.running) this.running.state = state;
    this.changed.emit();
  }

  /** Adds the baked light to the library, and uses it in the scene. */
  private async useBakedLight(scene: Scene, blob: Blob): Promise<void> {
    const { assets } = scene;
    const name = freeAssetName(assets, `${t('Baked light')}.bake`);
    assets.registerFile(name, blob);
    await assets.load(name);
    const taken = assets.take(name);
    if (this.editor.document.scene === scene) this.editor.commands.run(showBakedLight(scene, taken));
  }
}

const bakers = new WeakMap<EditorApi, LightBaker>();

/** The light baker of an editor, created at the first call. */
export function lightBakerOf(editor: EditorApi): LightBaker {
  let baker = bakers.get(editor);
  if (!baker) bakers.set(editor, (baker = new LightBaker(editor)));
  return baker;
}
