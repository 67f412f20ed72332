import { Signal } from '@farol/editing';
import type { Sound } from '@farol/engine';
import { AudioContext as SharedContext } from 'three';

/** Plays sounds of the library, one at a time, independent of the scene. */
class SoundPreview {
  /** Emits when playback starts, pauses or ends. */
  readonly changed = new Signal();

  private heard: Sound | null = null;
  private node: AudioBufferSourceNode | null = null;
  /** The paused sound and its position (s). */
  private held: { sound: Sound; at: number } | null = null;
  private beganAt = 0;

  /** The sound that plays; null for none. */
  get playing(): Sound | null {
    return this.heard;
  }

  /**
   * Plays a sound from its start or from where it was paused; pauses it if it plays. @throws Error (as a rejection)
   * when it cannot be decoded
   */
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

  /** Pauses the sound that plays, keeping its position. */
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

/** Shared by the whole page, so that only one sound plays at a time. */
export const soundPreview = new SoundPreview();
