import { type Texture, Vector2 } from 'three';
import type { Frame } from '../../frame/Frame';
import { FullscreenPass } from '../../gpu/FullscreenPass';
import type { BufferView } from './BufferView';

/** Shows the red channel of a buffer that has a texel for each pixel. */
export class PixelView implements BufferView {
  private readonly pass = new FullscreenPass({
    program: 'pixel view',
    fragment: 'pixelView',
    asThree: true,
    repeats: true,
    uniforms: { farol_buffer: { value: null as Texture | null }, farol_offset: { value: new Vector2() } },
  });

  /** @param find - returns the buffer, or a sentence on what the frame lacks */
  constructor(private readonly find: (frame: Frame) => Texture | string) {}

  show(frame: Frame): string | null {
    const found = this.find(frame);
    if (typeof found === 'string') return found;
    const { farol_buffer, farol_offset } = this.pass.uniforms;
    farol_buffer.value = found;
    farol_offset.value.set(frame.viewport.x, frame.viewport.y);
    frame.bindTarget();
    this.pass.draw(frame);
    return null;
  }

  dispose(): void {
    this.pass.dispose();
  }
}
