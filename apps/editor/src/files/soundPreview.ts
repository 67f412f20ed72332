import { Signal } from '@farol/editing';
import type { Sound } from '@farol/engine';
import { AudioContext as SharedContext } from 'three';

/** Plays sounds of the library to the user, one at a time, apart from every scene. */
class SoundPreview {
  /** Emits when another sound is heard, or none. */
  readonly changed = new Signal();

  private heard: Sound | null = null;
  private node: AudioBufferSourceNode | null = null;
  /** What was held, and where (s). */
  private held: { sound: Sound; at: number } | null = null;
  private beganAt = 0;

  /** The sound that is heard; null for none. */
  get playing(): Sound | null {
    return this.heard;
  }

  /** Plays a sound, from where it was held or from its beginning; holds the one that is heard. @throws Error (as a rejection) when it cannot be decoded */
  async toggle(sound: Sound): Promise<void> {
    const isHeard = this.heard === sound;
    this.hold();
    if (isHeard) return;
    const buffer = await sound.decode();
    if (!buffer) return;
    const context = SharedContext.getContext() as unknown as AudioContext;
    await context.resume();
    const from = this.held?.sound === sound ? this.held.at : 0;
    this.hold();
    const node = context.createBufferSource();
    node.buffer = buffer;
    node.connect(context.destination);
    node.addEventListener('ended', () => this.node === node && this.ended());
    node.start(0, from);
    Object.assign(this, { heard: sound, node, beganAt: context.currentTime - from });
    this.changed.emit();
  }

  /** Holds what is heard. */
  hold(): void {
    const { heard, node } = this;
    if (!heard || !node) return;
    this.held = { sound: heard, at: node.context.currentTime - this.beganAt };
    this.node = null;
    this.heard = null;
    node.stop();
    node.disconnect();
    this.changed.emit();
  }

  private ended(): void {
    this.held = null;
    this.heard = null;
    this.node = null;
    this.changed.emit();
  }
}

/** The page's one preview: two sounds at once are none. */
export const soundPreview = new SoundPreview();
