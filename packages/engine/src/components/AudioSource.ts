import { asset, boolean, choice, number } from '@farol/editing/fields';
import type { Scene } from '../core/Scene';
import { component } from '../core/Component';
import type { NewObject } from '../core/NewObject';

const whenPositional = { field: 'positional', equals: [true] } as const;

/**
 * Plays a sound while the scene plays. Browsers allow output after the user's first press: see `audioOutput`; a sound
 * started earlier is then heard from its current position.
 */
export class AudioSource extends component({
  sound: asset('sound', null, { help: 'The sound that it plays.' }),
  playOnStart: boolean(true, { help: 'Whether it plays as soon as the scene plays.', label: 'Play on start' }),
  loop: boolean(false, { help: 'Whether it begins anew at its end.' }),
  volume: number(1, { min: 0, max: 4, step: 0.05, help: 'Loudness; 1 is that of the file.' }),
  playbackRate: number(1, {
    min: 0.05,
    max: 8,
    step: 0.05,
    help: 'Factor of the speed, and with it of the pitch.',
    label: 'Playback rate',
  }),
  positional: boolean(true, { help: 'Whether it comes from where the object is, and fades with the distance.' }),
  falloff: choice('linear', ['linear', 'inverse', 'exponential'], {
    help: 'How it fades with the distance: linear falls silent at the range, the others never quite do.',
    visibleWhen: whenPositional,
    optionLabels: { linear: 'Linear', inverse: 'Inverse', exponential: 'Exponential' },
  }),
  referenceDistance: number(1, {
    unit: 'm',
    min: 0.01,
    step: 0.1,
    help: 'Up to this far it has its whole loudness.',
    label: 'Reference distance',
    visibleWhen: whenPositional,
  }),
  maxDistance: number(20, {
    unit: 'm',
    min: 0.01,
    step: 0.5,
    help: 'Farther away it is not heard.',
    label: 'Range',
    visibleWhen: { field: 'falloff', equals: ['linear'] },
  }),
  rolloff: number(1, {
    min: 0,
    max: 10,
    step: 0.1,
    help: 'How strongly it fades with the distance.',
    visibleWhen: { field: 'falloff', equals: ['inverse', 'exponential'] },
  }),
}) {
  static override readonly typeName: string = 'AudioSource';
  static override readonly icon: string = 'sound';
  static override readonly help: string = 'A sound that plays, from where the object is or everywhere.';
  static override readonly newObjects: readonly NewObject[] = [{ label: 'Sound' }];
  static override readonly callable: readonly string[] = ['play', 'stop', 'pause'];

  private state: 'stopped' | 'playing' | 'paused' = 'stopped';
  /** Scene time (s) at which the sound would have begun, had it always had its present rate. */
  private beganAt = 0;
  /** Position in the sound at which it was paused (s). */
  private pausedAt = 0;
  /** Playback rate since `beganAt`. */
  private rate = 1;
  private beginnings = 0;
  private changes = 0;

  /** Whether the sound plays: begun, and neither ended, stopped nor paused. */
  get isPlaying(): boolean {
    return this.state === 'playing';
  }

  /** Number of starts and resumptions. @internal */
  get beginning(): number {
    return this.beginnings;
  }

  /** Number of changes of field values. @internal */
  get revision(): number {
    return this.changes;
  }

  /** Playback position in the sound (s); grows beyond the sound's length when looping. */
  get position(): number {
    if (this.state === 'playing') return ((this.scene?.time ?? 0) - this.beganAt) * this.rate;
    return this.state === 'paused' ? this.pausedAt : 0;
  }

  /** Plays from the beginning, or from where it was paused. A playing sound restarts. */
  play(): void {
    if (!this.isActive) return;
    const from = this.state === 'paused' ? this.pausedAt : 0;
    this.rate = this.playbackRate;
    this.beganAt = (this.scene?.time ?? 0) - from / this.rate;
    this.state = 'playing';
    this.beginnings++;
  }

  /** Stops the sound: the next `play` starts at the beginning. */
  stop(): void {
    this.state = 'stopped';
  }

  /** Pauses the sound; the next `play` resumes it. */
  pause(): void {
    if (this.state !== 'playing') return;
    this.pausedAt = this.position;
    this.state = 'paused';
  }

  override start(): void {
    const { scene } = this;
    if (!scene) return;
    // SceneAudio is late code: fetched once a scene has a sound
    void import('../audio/SceneAudio').then(({ SceneAudio }) => this.scene === scene && scene.system(SceneAudio));
    if (this.playOnStart) this.play();
  }

  override onDestroy(): void {
    this.stop();
  }

  override onEnterScene(scene: Scene): void {
    const { sound } = this;
    // the error is ignored: the library reports a sound that cannot be loaded
    if (sound !== null && !scene.assets.isReady('sound', sound)) void scene.assets.load(sound).catch(() => {});
  }

  override onFieldChanged(name: string): void {
    this.changes++;
    const { scene } = this;
    if (name === 'playbackRate' && this.state === 'playing') {
      const { position } = this;
      this.rate = this.playbackRate;
      this.beganAt = (scene?.time ?? 0) - position / this.rate;
    }
    if (name !== 'sound' || !scene) return;
    this.onEnterScene(scene);
    if (this.state === 'playing') {
      this.stop();
      this.play();
    }
  }

  override onActiveChanged(): void {
    if (!this.isActive) this.stop();
    else if (this.scene?.isSimulated && this.playOnStart) this.play();
  }
}
