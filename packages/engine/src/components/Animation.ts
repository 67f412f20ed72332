import { asset, boolean, choice, number } from '@farol/editing/fields';
import { AnimationSystem, type Animated } from '../animation/AnimationSystem';
import type { ClipEvent } from '../assets/clips/ClipData';
import type { ClipWrap } from '../animation/clipEvents';
import { ClipPlayer } from '../animation/ClipPlayer';
import { modelBelow } from '../animation/modelsBelow';
import type { Scene } from '../core/Scene';
import { component } from '../core/Component';

/** Options of `Animation.play`; fields of the component give the values of absent options. */
export interface PlayOptions {
  /** Duration of the cross-fade to the new clip (s). */
  readonly fade?: number;
  readonly wrap?: ClipWrap;
  /** Factor on the clip's speed; below 0 it runs backwards. */
  readonly speed?: number;
  /** Time within the clip at which to begin (s). */
  readonly time?: number;
}

/**
 * Plays clips of models and clip assets on its object and all descendants. If several clips animate a value, also from
 * several Animations, their weighted mean is used.
 */
export class Animation
  extends component({
    clip: asset('clip', null, { help: 'What it plays: a clip of a model, or one of your own.' }),
    playOnStart: boolean(true, { help: 'Whether it plays as soon as the scene does.', label: 'Play on start' }),
    wrap: choice('loop', ['once', 'loop', 'ping-pong'], {
      label: 'At its end',
      help: 'It stays there, begins again, or goes back the way it came.',
      optionLabels: { once: 'Stay', loop: 'Loop', 'ping-pong': 'Ping-pong' },
    }),
    speed: number(1, { step: 0.1, help: 'Factor of the speed; below 0 it runs backwards.' }),
    startTime: number(0, {
      unit: 's',
      min: 0,
      step: 0.1,
      help: 'Where in the clip it begins; counted from the end when it runs backwards.',
      label: 'Start time',
    }),
    fade: number(0.3, {
      unit: 's',
      min: 0,
      step: 0.05,
      help: 'How long one clip fades into another.',
      label: 'Cross-fade',
    }),
  })
  implements Animated
{
  static override readonly typeName: string = 'Animation';
  static override readonly icon: string = 'animation';
  static override readonly help: string = 'Plays clips on the object and all below it.';
  static override readonly callable: readonly string[] = ['play', 'stop', 'pause'];

  /** Players of clips: the last one plays, earlier ones fade out. */
  private players: ClipPlayer[] = [];
  private system: AnimationSystem | null = null;
  private hasStarted = false;
  /** Scene time (s) at which the component entered the scene or was switched on or off; clips start from it. */
  private since = 0;
  private readonly reported = new Set<string>();

  /** Names that `play` accepts: the model's clips by their names in the file, then clips of the library. */
  get clipNames(): string[] {
    const { scene } = this;
    if (!scene) return [];
    const own = modelBelow(this.gameObject, null)?.drawnModel?.clips.map(({ name }) => name) ?? [];
    return [...own, ...scene.assets.list('clip')];
  }

  /** Whether a clip is playing: neither paused nor finished. */
  get isPlaying(): boolean {
    const { current } = this;
    return current !== null && !current.isPaused && !current.isFinished(this.scene?.time ?? 0);
  }

  /** Name of the clip that is playing or paused; null for none. */
  get playing(): string | null {
    return this.current?.name ?? null;
  }

  /** Time within the clip that is playing (s); 0 for none. */
  get time(): number {
    return this.current?.timeAt(this.scene?.time ?? 0) ?? 0;
  }

  set time(seconds: number) {
    this.current?.seek(seconds, this.scene?.time ?? 0);
  }

  /**
   * Plays a clip; the present one fades out. A clip that plays already continues.
   * @param name - of a clip of the library, or of a clip of the model as in its file; the field `clip` when absent
   * @throws Error naming the known clips when the name is unknown
   */
  play(name?: string, options: PlayOptions = {}): void {
    const { scene, system } = this;
    if (!scene || !system) throw new Error('Animation.play: its object is in no scene; add it first.');
    const { time } = scene;
    const clip = typeof name === 'string' && name !== '' ? this.find(name) : this.clip;
    this.hasStarted = true;
    if (clip === null) return;
    const before = this.current;
    if (before?.name === clip && !before.isFinished(time)) {
      before.setPaused(false, time);
      if (options.speed !== undefined) before.setRate(options.speed, time);
      if (options.time !== undefined) before.seek(options.time, time);
      return;
    }
    const fade = before ? (options.fade ?? this.fade) : (options.fade ?? 0);
    for (const each of this.players) each.fade(0, fade, time);
    const player = new ClipPlayer(clip, this, system, time, {
      wrap: options.wrap ?? (this.wrap as ClipWrap),
      rate: options.speed ?? this.speed,
      startTime: options.time ?? this.startTime,
    });
    player.fade(1, fade, time, fade > 0 ? 0 : 1);
    this.players.push(player);
  }

  /**
   * Stops all clips: the object returns to its authored values.
   * @param options - `fade`: duration of the fade-out (s)
   */
  stop(options?: { readonly fade?: number }): void {
    this.hasStarted = true;
    const fade = options?.fade ?? 0;
    for (const each of this.players) each.fade(0, fade, this.scene?.time ?? 0);
  }

  /** Pauses the clip; `play` resumes. */
  pause(): void {
    this.current?.setPaused(true, this.scene?.time ?? 0);
  }

  override onEnterScene(scene: Scene): void {
    this.system = scene.system(AnimationSystem);
    this.system.add(this);
    this.since = scene.time;
    this.loadClip();
  }

  override onLeaveScene(): void {
    this.clear();
    this.system?.remove(this);
    this.system = null;
  }

  override onFieldChanged(name: string): void {
    const { scene } = this;
    if (!scene) return;
    const { time } = scene;
    if (name === 'clip') {
      this.loadClip();
      if (this.current) this.replaceClip();
    } else if (name === 'speed') this.current?.setRate(this.speed, time);
    else if (name === 'wrap' && this.current) this.current.wrap = this.wrap as ClipWrap;
  }

  override onActiveChanged(): void {
    this.clear();
    this.since = this.scene?.time ?? 0;
  }

  evaluate(time: number): void {
    if (!this.hasStarted) {
      this.hasStarted = true;
      if (this.playOnStart && this.clip !== null) this.begin();
    }
    const { players } = this;
    for (let i = 0; i < players.length; i++) {
      if (players[i].isFadedOut(time)) {
        players[i].dispose();
        players.splice(i--, 1);
      } else players[i].evaluate(time);
    }
  }

  passEvents(time: number, isCalling: boolean): void {
    const { players } = this;
    for (let i = 0; i < players.length; i++) players[i].passEvents(time, isCalling, this.queueEvent);
  }

  targetsChanged(): void {
    for (const each of this.players) each.isStale = true;
  }

  resetPlayers(): void {
    this.clear();
    this.since = 0;
    this.reported.clear();
  }

  tellProblem(clip: string, problem: string): void {
    const text = problem.startsWith('The clip') ? problem : `The clip '${clip}': ${problem}`;
    if (this.reported.has(text)) return;
    this.reported.add(text);
    this.system?.tellOf(this, new Error(text));
  }

  private get current(): ClipPlayer | null {
    const last = this.players.at(-1);
    return last && !last.isFadingOut ? last : null;
  }

  private readonly queueEvent = (event: ClipEvent): void => this.system?.queueEvent(this, event);

  private begin(): void {
    const { wrap, speed: rate, startTime } = this;
    const options = { wrap: wrap as ClipWrap, rate, startTime };
    this.players.push(new ClipPlayer(this.clip!, this, this.system!, this.since, options));
  }

  /** Plays a newly chosen clip in place of the one that is playing. */
  private replaceClip(): void {
    this.clear();
    this.hasStarted = true;
    this.since = this.scene!.time;
    if (this.clip !== null) this.begin();
  }

  private clear(): void {
    for (const each of this.players) each.dispose();
    this.players.length = 0;
    this.hasStarted = false;
  }

  /** Library name of a clip that a script names. */
  private find(name: string): string {
    const { assets } = this.scene!;
    if (assets.has(name, 'clip')) return name;
    const chosen = this.clip === null ? null : assets.modelOf(this.clip);
    const models = [
      modelBelow(this.gameObject, null)?.drawnModel ?? null,
      chosen && assets.isReady('model', chosen) ? assets.model(chosen) : null,
    ];
    for (const model of models) {
      const clip = model?.clips.find((each) => each.name === name);
      const found = clip && assets.nameOf(clip);
      if (found) return found;
    }
    const leaf = assets.list('clip').find((each) => each.endsWith(`/${name}`));
    if (leaf !== undefined) return leaf;
    throw new Error(
      `Animation.play: there is no clip '${name}'; there are ${this.clipNames.slice(0, 8).join(', ') || 'none'}.`,
    );
  }

  /** Loads the model of a clip, if it is not loaded yet. */
  private loadClip(): void {
    const { scene, clip } = this;
    // the error is ignored: the library reports a model that cannot be loaded
    if (scene && clip !== null && !scene.assets.isReady('clip', clip)) void scene.assets.load(clip).catch(() => {});
  }
}
