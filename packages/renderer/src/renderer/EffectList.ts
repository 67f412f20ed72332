import type { WebGLRenderer, WebGLRenderTarget } from 'three';
import { type ActiveEffects, activeEffects, NO_EFFECTS, refuseConflicts } from '../frame/ActiveEffects';
import type { FarolEffect } from '../frame/FarolEffect';
import type { Session } from '../frame/Session';
import { gbufferLayout } from '../gbuffer/gbufferLayout';
import { drawBuffersOf } from '../gpu/checkDevice';

/** The host's effects, and those of them that can be drawn; warns once of each effect that is left out. */
export class EffectList {
  private list: readonly FarolEffect[] = [];
  /** Copy of the list for which `active` was made, with the target's traits below; the host may push to its list. */
  private known: readonly FarolEffect[] = [];
  private count = 0;
  private several = false;
  private stereo = false;
  private active: ActiveEffects = NO_EFFECTS;
  private readonly reported = new WeakSet<FarolEffect>();
  /** All effects that were ever in the list: the host may put removed ones back in. */
  private everListed: WeakRef<FarolEffect>[] = [];

  constructor(private readonly webgl: WebGLRenderer) {}

  /** The host's list. @throws Error when set to a list in which two effects conflict */
  get hostEffects(): readonly FarolEffect[] {
    return this.list;
  }

  set hostEffects(effects: readonly FarolEffect[]) {
    refuseConflicts(effects);
    this.list = effects;
  }

  /**
   * The effects that draw a frame.
   * @param target - the host's target
   * @param session - XR session whose eye is drawn, which may bring its own effects; null outside of XR
   * @throws Error when an effect that the host pushed to its list conflicts with another
   */
  of(target: WebGLRenderTarget | null, session: Session | null): ActiveEffects {
    if (session?.effects !== undefined) return session.effects;
    const stereo = session !== null;
    const { list } = this;
    const several = target !== null && target.textures.length > 1;
    const same = list === this.known && list.length === this.count;
    if (same && several === this.several && stereo === this.stereo) return this.active;
    refuseConflicts(list);
    this.meet(list);
    this.known = list;
    this.count = list.length;
    this.several = several;
    this.stereo = stereo;
    const room = drawBuffersOf(this.webgl.getContext() as WebGL2RenderingContext) - gbufferLayout.length;
    this.active = list.length === 0 ? NO_EFFECTS : activeEffects(list.filter(this.canRun), room);
    return this.active;
  }

  /** Frees the GPU resources of all effects that were ever in the list; a later frame creates them again. */
  dispose(): void {
    // the next frame checks again which effects the device supports: the context may have been restored
    this.count = -1;
    for (const reference of this.everListed) reference.deref()?.dispose();
  }

  private meet(effects: readonly FarolEffect[]): void {
    const known = new Set<unknown>();
    this.everListed = this.everListed.filter(
      (reference) => known.add(reference.deref()) && reference.deref() !== undefined,
    );
    for (const effect of effects) if (!known.has(effect)) this.everListed.push(new WeakRef(effect));
  }

  private readonly canRun = (effect: FarolEffect): boolean => {
    const lacks = effect.lacks?.(this.webgl) ?? null;
    const apart = this.several && effect.takesPicture === true;
    const gathers = this.stereo && effect.movesCamera === true;
    if (lacks === null && !apart && !gathers) return true;
    const why = apart
      ? 'the target has several textures'
      : 'it gathers frames of one camera, and XR has one for each eye';
    const reason = lacks === null ? why : `this device ${lacks}`;
    if (!this.reported.has(effect)) console.warn(`Farol: ${effect.name} is left out, since ${reason}.`);
    this.reported.add(effect);
    return false;
  };
}
