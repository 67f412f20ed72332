import type { Object3D } from 'three';
import { ObjectMotion } from './ObjectMotion';

/** Number of frames after which the textures of an object out of view are freed. */
const UNSEEN = 60;

/** States of objects in the last frame of one camera and scene. */
export class ObjectMotions {
  private known = new WeakMap<Object3D, ObjectMotion>();
  /** Objects whose state has textures. */
  private readonly holders: ObjectMotion[] = [];

  of(object: Object3D): ObjectMotion {
    let motion = this.known.get(object);
    if (motion === undefined) this.known.set(object, (motion = new ObjectMotion()));
    return motion;
  }

  /** Copies an object's matrix, bones and morphs in a frame, for the next frame to compare with. */
  remember(object: Object3D, frame: number): void {
    const motion = this.of(object);
    motion.remember(object, frame);
    if (!motion.holds || motion.listed) return;
    motion.listed = true;
    this.holders.push(motion);
  }

  /** Frees the textures of objects not seen for UNSEEN frames. */
  forget(frame: number): void {
    const { holders } = this;
    let kept = 0;
    for (let i = 0; i < holders.length; i++) {
      if (holders[i].frame < frame - UNSEEN) holders[i].dispose();
      else holders[kept++] = holders[i];
    }
    holders.length = kept;
  }

  dispose(): void {
    for (const motion of this.holders) motion.dispose();
    this.holders.length = 0;
    this.known = new WeakMap();
  }
}
