import { Signal } from '@farol/editing';
import { type GameObject, ParticleEmitter } from '@farol/engine';
import type { EditorDocument } from '../../model/EditorDocument';
import { LineSet } from '../LineSet';
import { drawEmitter } from './drawEmitter';

/** Parts of the viewport that the particle preview uses. */
export interface PreviewHost {
  readonly document: EditorDocument;
  /** Notifies panels that show the viewport's state. */
  viewChanged(): void;
}

/** Colour of the shapes of selected emitters. */
const COLOUR = '#ffb454';
/** Longest time step of a frame (s). */
const LONGEST_STEP = 0.1;

/**
 * Plays emitters of selected objects and their descendants while the scene is stopped. Edits nothing; an emitter
 * restarts when it is deselected.
 */
export class ParticlePreview {
  /** Emits when the set of emitters, or playback, changes. */
  readonly changed = new Signal();
  readonly lines = new LineSet(COLOUR);
  private isRunning = !matchMedia('(prefers-reduced-motion: reduce)').matches;
  private factor = 1;
  private shown: readonly ParticleEmitter[] = [];
  private key = '';

  constructor(private readonly host: PreviewHost) {}

  /** The emitters that play, without those removed from the scene since the last frame. */
  get emitters(): readonly ParticleEmitter[] {
    return this.shown.filter(({ scene }) => scene !== null);
  }

  /** Whether the preview is running rather than paused. */
  get isPlaying(): boolean {
    return this.isRunning;
  }

  set isPlaying(isPlaying: boolean) {
    this.isRunning = isPlaying;
    this.changed.emit();
  }

  /** Time factor; 1 for normal speed. */
  get speed(): number {
    return this.factor;
  }

  set speed(speed: number) {
    this.factor = speed;
    this.changed.emit();
  }

  /** Time since the emitters started (s). */
  get time(): number {
    return Math.max(0, ...this.shown.map(({ three }) => three?.time ?? 0));
  }

  /** Upper bound of the number of live particles, as if all had the longest life. */
  get count(): number {
    return this.shown.reduce((sum, { three }) => {
      const schedule = three?.pending.schedule;
      return sum + (schedule ? schedule.begun - schedule.oldest : 0);
    }, 0);
  }

  restart(): void {
    for (const emitter of this.shown) emitter.restart();
    this.host.viewChanged();
  }

  /** Advances time. @returns whether a frame must be drawn */
  advance(seconds: number): boolean {
    this.follow();
    if (this.shown.length === 0 || !this.isRunning) return false;
    const step = Math.min(Math.max(seconds, 0), LONGEST_STEP) * this.factor;
    for (let i = 0; i < this.shown.length; i++) if (this.shown[i].isActive) this.shown[i].advance(step);
    return true;
  }

  /** Rebuilds the shapes of selected emitters; called before each frame. */
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

  /** Looks up the emitters to play, when selection or scene changed. */
  private follow(): void {
    const { selection, structure, simulation, opened } = this.host.document;
    const key = `${selection.changed.revision} ${structure.revision} ${simulation.changed.revision} ${opened.revision}`;
    if (key === this.key) return;
    this.key = key;
    const isStopped = simulation.state === 'stopped';
    const found = isStopped ? emittersBelow(this.host.document.selectedObjects) : [];
    if (found.length === this.shown.length && found.every((emitter, i) => emitter === this.shown[i])) return;
    // a playing scene restarts its emitters itself
    if (isStopped) for (const emitter of this.shown) if (!found.includes(emitter) && emitter.scene) emitter.restart();
    this.shown = found;
    this.changed.emit();
    this.host.viewChanged();
  }
}

function emittersBelow(objects: readonly GameObject[]): ParticleEmitter[] {
  const found = new Set<ParticleEmitter>();
  for (const object of objects) {
    object.traverse(({ components }) => {
      for (const component of components) if (component instanceof ParticleEmitter) found.add(component);
    });
  }
  return [...found];
}
