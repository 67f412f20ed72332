import type { ModelClip } from '../assets/Model';
import type { GameObject } from '../core/GameObject';
import { bindModelClip, type BoundClip } from './bindClip';
import { FieldChannel, NodeChannel } from './Channel';
import { wrapTime } from './clipEvents';
import type { ModelInScene } from './modelsBelow';

/** Plays one clip of a model in an endless loop, for fields of ModelRenderer and Animator in older files. */
export class LoopedClip {
  private readonly bound: BoundClip;

  /** @param drawn - renderer of the model; null when the model was unpacked into objects below `root` */
  constructor(clip: ModelClip, root: GameObject, drawn: ModelInScene | null) {
    this.bound = bindModelClip(clip, root, drawn ? [drawn] : [], {
      fieldChannel: (component, field) => new FieldChannel(component, field),
      nodeChannel: (node, property) => new NodeChannel(node, property),
    });
  }

  /** @param seconds - position in the clip; negative when running backwards */
  show(seconds: number): void {
    const { bindings, duration } = this.bound;
    const at = wrapTime(seconds, duration, 'loop');
    for (let i = 0; i < bindings.length; i++) {
      const { channel, interpolant, isQuaternion } = bindings[i];
      const values = interpolant!.evaluate(at) as ArrayLike<number>;
      channel.begin();
      if (isQuaternion) channel.addQuaternion(values, 1);
      else channel.add(values, 1);
      channel.apply();
    }
  }

  /** Restores the values from before the clip. */
  end(): void {
    for (const { channel } of this.bound.bindings) channel.release();
  }
}
