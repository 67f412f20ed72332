import type { ClipAsset } from '../assets/clips/ClipAsset';
import type { ModelClip } from '../assets/Model';
import type { Object3D } from 'three';
import type { GameObject } from '../core/GameObject';
import type { AnimationSystem } from './AnimationSystem';
import { bindModelClip, bindOwnClip, type BoundClip } from './bindClip';
import type { ClipEvent } from '../assets/clips/ClipData';
import { type ClipWrap, passEvents, wrapTime } from './clipEvents';
import { modelsBelow, type ModelInScene } from './modelsBelow';

const numbers = new Float64Array(3);

const nothing: BoundClip = { duration: 0, events: [], bindings: [], problems: [] };

/** Wrap, rate and start of a played clip. */
export interface PlayerOptions {
  readonly wrap: ClipWrap;
  /** Playback rate: seconds of the clip per second of the scene. */
  readonly rate: number;
  /** Start position in the clip (s); counted from the clip's end when `rate` is negative. */
  readonly startTime: number;
}

/** Owner of a ClipPlayer, which reports problems to the user. */
export interface PlayerHost {
  readonly gameObject: GameObject;
  /** Reports why a clip cannot be played. */
  tellProblem(clip: string, problem: string): void;
}

/** Plays one clip on an object; position and weight depend on the scene's time alone. */
export class ClipPlayer {
  wrap: ClipWrap;
  isPaused = false;
  /** Whether bindings are out of date, so that `evaluate` rebinds the clip first. */
  isStale = true;
  private bound = nothing;
  private clip: ClipAsset | ModelClip | null = null;
  private text: unknown = null;
  private revision = -1;
  private drawn: readonly ModelInScene[] = [];
  private roots: readonly (Object3D | null)[] = [];
  /** Scene time (s) at which the clip's position was `offset`. */
  private origin: number;
  private offset = 0;
  private rate: number;
  private readonly startTime: number;
  private hasBegun = false;
  private fadeOrigin = 0;
  private fadeSeconds = 0;
  private fadeFrom = 1;
  private fadeTo = 1;
  /** Clip position (s, unwrapped: it goes on beyond the clip's ends) up to which events have been called. */
  private eventsUntil = 0;
  private withFirst = true;

  constructor(
    /** The name of the clip in the library. */
    readonly name: string,
    private readonly host: PlayerHost,
    private readonly system: AnimationSystem,
    time: number,
    { wrap, rate, startTime }: PlayerOptions,
  ) {
    this.wrap = wrap;
    this.rate = rate;
    this.startTime = startTime;
    this.origin = time;
  }

  /** Duration of the clip (s); 0 until loaded. */
  get duration(): number {
    return this.bound.duration;
  }

  /** Whether the clip has reached its end and stays there (`wrap` 'once'). */
  isFinished(time: number): boolean {
    if (this.wrap !== 'once' || !this.hasBegun) return false;
    const at = this.position(time);
    return this.rate < 0 ? at <= 0 : at >= this.bound.duration;
  }

  isFadedOut(time: number): boolean {
    return this.fadeTo === 0 && time >= this.fadeOrigin + this.fadeSeconds;
  }

  get isFadingOut(): boolean {
    return this.fadeTo === 0;
  }

  /** Weight of the clip in blending, 0 to 1. */
  weight(time: number): number {
    const { fadeSeconds, fadeFrom, fadeTo } = this;
    const share = fadeSeconds > 0 ? Math.min(Math.max((time - this.fadeOrigin) / fadeSeconds, 0), 1) : 1;
    return fadeFrom + (fadeTo - fadeFrom) * share;
  }

  /** Begins to fade the clip's weight linearly in (1) or out (0). */
  fade(to: 0 | 1, seconds: number, time: number, from = this.weight(time)): void {
    this.fadeFrom = from;
    this.fadeTo = to;
    this.fadeOrigin = time;
    this.fadeSeconds = seconds;
  }

  setRate(rate: number, time: number): void {
    this.begin();
    this.offset = this.position(time);
    this.origin = time;
    this.rate = rate;
  }

  setPaused(isPaused: boolean, time: number): void {
    if (isPaused === this.isPaused) return;
    this.offset = this.position(time);
    this.origin = time;
    this.isPaused = isPaused;
  }

  /** Position within the clip (s), wrapped. */
  timeAt(time: number): number {
    return wrapTime(this.position(time), this.bound.duration, this.wrap, this.rate < 0);
  }

  seek(seconds: number, time: number): void {
    this.begin();
    this.hasBegun = true;
    this.offset = this.eventsUntil = seconds;
    this.withFirst = true;
    this.origin = time;
  }

  /** Adds the clip's weighted values to the animation channels. */
  evaluate(time: number): void {
    const weight = this.weight(time);
    if (this.isStale || this.hasChanged) this.bind();
    this.begin();
    if (weight <= 0) return;
    const at = this.timeAt(time);
    const { bindings } = this.bound;
    for (let i = 0; i < bindings.length; i++) {
      const binding = bindings[i];
      const { channel, curve } = binding;
      if (channel.isGone) {
        this.isStale = true;
        continue;
      }
      this.system.touch(channel);
      if (!curve) {
        const values = binding.interpolant!.evaluate(at) as ArrayLike<number>;
        if (binding.isQuaternion) channel.addQuaternion(values, weight);
        else channel.add(values, weight);
        continue;
      }
      binding.index = curve.indexAt(at, binding.index);
      if (curve.size === 0) channel.addStep(curve.stepAt(binding.index), weight);
      else {
        curve.evaluate(at, binding.index, numbers);
        channel.add(numbers, weight);
      }
    }
  }

  /** Calls events passed since the last call. @param isCalling - false skips them */
  passEvents(time: number, isCalling: boolean, call: (event: ClipEvent) => void): void {
    if (!this.hasBegun) return;
    const { duration, events } = this.bound;
    let to = this.position(time);
    if (this.wrap === 'once') to = Math.min(Math.max(to, 0), duration);
    if (isCalling) passEvents(events, duration, this.wrap, this.eventsUntil, to, this.withFirst, call);
    this.eventsUntil = to;
    this.withFirst = false;
  }

  dispose(): void {
    for (const { channel } of this.bound.bindings) channel.users--;
    this.bound = nothing;
    this.isStale = true;
  }

  /** Unwrapped position (s) since the beginning of the clip. */
  private position(time: number): number {
    return this.isPaused ? this.offset : this.offset + Math.max(time - this.origin, 0) * this.rate;
  }

  /** Sets the start position once, when the clip's duration is known. */
  private begin(): void {
    if (this.hasBegun || !this.clip) return;
    this.hasBegun = true;
    this.offset = this.eventsUntil = this.rate < 0 ? this.bound.duration - this.startTime : this.startTime;
  }

  /** Whether tracks must be rebound: the ModelRenderer made a new tree, or the clip was replaced. */
  private get hasChanged(): boolean {
    for (let i = 0; i < this.drawn.length; i++) if (this.drawn[i].three !== this.roots[i]) return true;
    if (this.revision === this.system.clipsRevision) return false;
    this.revision = this.system.clipsRevision;
    const { assets } = this.system.scene;
    if (!this.clip || !assets.isReady('clip', this.name) || assets.clip(this.name) !== this.clip) return true;
    if ('isModelClip' in this.clip) return false;
    // missing targets may have appeared with a model loaded since
    if (this.bound.problems.length > 0) return true;
    return this.clip.get('data') !== this.text || this.clip.duration !== this.duration;
  }

  private bind(): void {
    const { system, host, name } = this;
    const { assets } = system.scene;
    const old = this.bound;
    this.clip = null;
    this.drawn = [];
    this.revision = system.clipsRevision;
    this.bound = nothing;
    this.isStale = false;
    try {
      if (assets.isReady('clip', name)) {
        const clip = (this.clip = assets.clip(name));
        if ('isModelClip' in clip) this.bound = this.bindModel(clip);
        else {
          this.text = clip.get('data');
          this.bound = { ...nothing, duration: clip.duration };
          this.bound = bindOwnClip(clip, host.gameObject, system);
        }
      } else if (!assets.has(name, 'clip')) host.tellProblem(name, 'it is gone: choose another clip.');
    } catch (error) {
      host.tellProblem(name, (error as Error).message);
    }
    for (const { channel } of this.bound.bindings) channel.users++;
    for (const { channel } of old.bindings) channel.users--;
    for (const problem of this.bound.problems) host.tellProblem(name, problem);
  }

  private bindModel(clip: ModelClip): BoundClip {
    const { gameObject } = this.host;
    this.drawn = modelsBelow(gameObject, clip.model);
    this.roots = this.drawn.map(({ three }) => three);
    return bindModelClip(clip, gameObject, this.drawn, this.system);
  }
}
