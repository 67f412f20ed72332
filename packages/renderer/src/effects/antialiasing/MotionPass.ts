import { HalfFloatType, Matrix4, NearestFilter, WebGLRenderTarget, type Object3D, type Vector2 } from 'three';
import type { Frame } from '../../frame/Frame';
import { fitTargetTo } from '../../gpu/fitTarget';
import type { ReactiveMaterial } from '../../frame/ReactiveMask';
import { surfacesOf } from '../../materials/surfacesOf';
import { targetBytes } from '../../gpu/targetBytes';
import type { RenderItem } from '../../frame/RenderItem';
import { hasMotionTwin, motionTwins } from './motionTwin';
import type { ObjectMotions } from './ObjectMotions';

const clip = new Matrix4();

/**
 * Draws the motion of moving objects' visible pixels since the last frame (x, y: in widths and heights of the picture;
 * z: former minus present distance, m; alpha: 1 where drawn), also of skins, morphs, instances and batches. Pixels that
 * only the camera moves are left out.
 */
export class MotionPass {
  /** Whether the pass has drawn in this frame. */
  drawn = false;
  changed = false;
  /** Whether former positions of all moving objects are known, and each of them also moved in the last frame. */
  known = true;
  /** Whether an object has moved that this pass cannot draw: a transparent one, or one with the host's own shader. */
  undrawn = false;
  target: WebGLRenderTarget | null = null;
  private readonly uniforms;
  private readonly twins;
  private slot = 0;
  private readonly objects: Object3D[] = [];

  /** @param jitter - jitter of the frame (normalised device coordinates) */
  constructor(jitter: Vector2) {
    this.uniforms = {
      farol_clipBefore: { value: new Matrix4() },
      farol_jitter: { value: jitter },
      farol_bonesBefore: { value: null as unknown },
      farol_instancesBefore: { value: null as unknown },
      farol_morphBaseBefore: { value: 1 },
      farol_morphsBefore: { value: [] as number[] },
    };
    this.twins = motionTwins(this.uniforms);
  }

  get bytes(): number {
    return this.target === null ? 0 : targetBytes(this.target, false);
  }

  /**
   * @param motions - states of objects in this camera's last frame; updated to this frame
   * @param number - number of this frame
   * @param before - last frame's projection × view
   * @param picture - finished picture, whose depth hides motion behind its surfaces
   */
  render(frame: Frame, motions: ObjectMotions, number: number, before: Matrix4, picture: WebGLRenderTarget): void {
    this.drawn = this.changed = false;
    this.known = true;
    this.undrawn = false;
    this.objects.length = 0;
    this.draw(frame, frame.queue.opaque, motions, number, before, picture);
    this.draw(frame, frame.queue.transmissive, motions, number, before, picture);
    this.draw(frame, frame.queue.transparent, motions, number, before, picture);
    for (const object of this.objects) motions.remember(object, number);
    motions.forget(number);
  }

  dispose(): void {
    this.target?.dispose();
    this.target = null;
  }

  private draw(
    frame: Frame,
    items: readonly RenderItem[],
    motions: ObjectMotions,
    number: number,
    before: Matrix4,
    picture: WebGLRenderTarget,
  ): void {
    for (const item of items) {
      const { object } = item;
      if ((item.material as ReactiveMaterial).isReactive === true) continue;
      const motion = motions.of(object);
      if (motion.frame === number) continue; // the object was already compared, for another of its material groups
      const isNew = motion.frame !== number - 1;
      const moved = !isNew && motion.hasMoved(object);
      if (!isNew && !moved) {
        motion.frame = number;
        motion.moves = false;
        continue;
      }
      this.changed = true;
      this.objects.push(object);
      if (isNew || !motion.moves) this.known = false;
      motion.moves = moved;
      if (isNew || !motion.isKnown(object) || !hasMotionTwin(item)) {
        this.known = false;
        if (!isNew) this.undrawn = true;
        continue;
      }
      this.bind(frame, picture);
      const { uniforms } = this;
      uniforms.farol_clipBefore.value.multiplyMatrices(before, clip.fromArray(motion.matrix));
      uniforms.farol_bonesBefore.value = motion.bones;
      uniforms.farol_instancesBefore.value = motion.instances;
      uniforms.farol_morphBaseBefore.value = motion.morphBase;
      uniforms.farol_morphsBefore.value = motion.morphs;
      surfacesOf(item.material)?.setTimesBefore(motion.surfaceTimes);
      frame.drawTwin(item, this.twins[this.slot]);
      this.slot = 1 - this.slot;
    }
  }

  private bind(frame: Frame, picture: WebGLRenderTarget): void {
    if (this.drawn) return;
    this.drawn = true;
    const { width, height } = picture;
    if (this.target !== null && this.target.depthTexture !== picture.depthTexture) this.dispose();
    this.target ??= new WebGLRenderTarget(width, height, {
      type: HalfFloatType,
      minFilter: NearestFilter,
      magFilter: NearestFilter,
      stencilBuffer: picture.stencilBuffer,
      depthTexture: picture.depthTexture!,
    });
    fitTargetTo(this.target, picture);
    frame.bind(this.target);
    frame.clear(1, false);
  }
}
