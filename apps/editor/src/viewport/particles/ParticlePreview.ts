import { Signal } from '@farol/editing';
import { type GameObject, ParticleEmitter } from '@farol/engine';
import { LineSet } from '../LineSet';
import { drawEmitter } from './drawEmitter';
import type { PreviewHost } from './LateParticlePreview';

/** Of the shapes of selected emitters. */
const COLOUR = '#ffb454';
/** Longest time that one frame may advance (s). */
const LONGEST_STEP = 0.1;

/**
 * Plays the emitters that are selected, or below what is, while the scene is stopped. It edits nothing: what it played begins
 * anew once it is no longer selected.
 */
export class ParticlePreview {
  /** Emits when other emitters play, or they play otherwise. */
  readonly changed = new Signal();
  readonly lines = new LineSet(COLOUR);
  private isRunning = !matchMedia('(prefers-reduced-motion: reduce)').matches;
  private factor = 1;
  private shown: readonly ParticleEmitter[] = [];
  private key = '';

  constructor(private readonly host: PreviewHost) {}

  /** The emitters that it plays, without those that have left the scene since the last frame. */
  get emitters(): readonly ParticleEmitter[] {
    return this.shown.filter(({ scene }) => scene !== null);
  }

  /** Whether time passes. */
  get isPlaying(): boolean {
    return this.isRunning;
  }

  set isPlaying(isPlaying: boolean) {
    this.isRunning = isPlaying;
    this.changed.emit();
  }

  /** Factor of the time; 1 as it will play. */
  get speed(): number {
    return this.factor;
  }

  set speed(speed: number) {
    this.factor = speed;
    this.changed.emit();
  }

  /** Time since they began (s). */
  get time(): number {
    return Math.max(0, ...this.shown.map(({ three }) => three?.time ?? 0));
  }

  /** Particles that live, at most: all are counted for the longest life. */
  get count(): number {
    return this.shown.reduce((sum, { three }) => {
      const schedule = three?.pending.schedule;
      return sum + (schedule ? schedule.begun - schedule.oldest : 0);
    }, 0);
  }

  /** Has all begin anew. */
  restart(): void {
    for (const emitter of this.shown) emitter.restart();
    this.host.viewChanged();
  }

  /** Lets time pass. @returns whether a frame is to be drawn */
  advance(seconds: number): boolean {
    this.follow();
    if (this.shown.length === 0 || !this.isRunning) return false;
    const step = Math.min(Math.max(seconds, 0), LONGEST_STEP) * this.factor;
    for (let i = 0; i < this.shown.length; i++) if (this.shown[i].isActive) this.shown[i].advance(step);
    return true;
  }

  /** Draws the shapes of selected emitters anew; called before each picture. */
  update(): void {
    this.lines.begin();
    for (const object of this.host.document.selectedObjects) {
      for (const component of object.components) {
        if (component instanceof ParticleEmitter) drawEmitter(this.lines, component);
      }
    }
    this.lines.end();
  }

  dispose(): void {
    this.lines.dispose();
  }

  /** Finds the emitters to play, when others may be. */
  private follow(): void {
    const { selection, structure, simulation, opened } = this.host.document;
    const key = `${selection.changed.revision} ${structure.revision} ${simulation.changed.revision} ${opened.revision}`;
    if (key === this.key) return;
    this.key = key;
    const isStopped = simulation.state === 'stopped';
    const found = isStopped ? emittersBelow(this.host.document.selectedObjects) : [];
    if (found.length === this.shown.length && found.every((emitter, i) => emitter === this.shown[i])) return;
    // what plays with the scene begins with it by itself
    if (isStopped) for (const emitter of this.shown) if (!found.includes(emitter) && emitter.scene) emitter.restart();
    this.shown = found;
    this.changed.emit();
    this.host.viewChanged();
  }
}

/** The emitters of objects and of all below them. */
function emittersBelow(objects: readonly GameObject[]): ParticleEmitter[] {
  const found = new Set<ParticleEmitter>();
  for (const object of objects) {
    object.traverse(({ components }) => {
      for (const component of components) if (component instanceof ParticleEmitter) found.add(component);
    });
  }
  return [...found];
}
