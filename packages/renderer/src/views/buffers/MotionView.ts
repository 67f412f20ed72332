import { type IUniform, Vector2 } from 'three';
import type { Frame } from '../../frame/Frame';
import { FullscreenPass } from '../../gpu/FullscreenPass';
import type { BufferView, ShownView } from './BufferView';
import { problems } from './problems';

/** Motion (pixels a frame) that is shown in full brightness. */
const FULL_MOTION = 16;

/** Shows the motion of each pixel since the last frame. */
export class MotionView implements BufferView {
  private readonly offset = { value: new Vector2() };
  private uniforms: Record<string, IUniform> | null = null;
  private pass: FullscreenPass | null = null;

  show(frame: Frame, info: ShownView): string | null {
    const motion = frame.resources.find('motion');
    if (motion === undefined) return problems.motion;
    if (this.uniforms !== motion.uniforms) this.make(motion.uniforms);
    this.offset.value.set(frame.viewport.x, frame.viewport.y);
    frame.bindTarget();
    this.pass!.draw(frame);
    info.fullMotion = FULL_MOTION;
    return null;
  }

  dispose(): void {
    this.pass?.dispose();
    this.pass = this.uniforms = null;
  }

  /** Makes the pass for the uniforms of one TAA effect. */
  private make(uniforms: Record<string, IUniform>): void {
    this.dispose();
    this.uniforms = uniforms;
    this.pass = new FullscreenPass({
      program: 'motion view',
      fragment: 'motionView',
      shared: ['farol_frameSize'],
      asThree: true,
      repeats: true,
      uniforms: { ...uniforms, farol_offset: this.offset, farol_fullMotion: { value: FULL_MOTION } },
    });
  }
}
