import type { IUniform, Texture } from 'three';
import type { Frame } from '../../frame/Frame';
import { type GBufferUniforms, gbufferUniforms, setGBufferUniforms } from '../../passes/gbuffer/gbufferUniforms';
import type { LightLists } from '../../frame/LightLists';
import { OutputPass } from '../../passes/output/OutputPass';

interface TiledUniforms extends GBufferUniforms {
  dfgLUT: IUniform<Texture | null>;
}

/** Shades every pixel of the G-buffer once, by the light list of its tile. */
export class TiledOutputPass extends OutputPass<TiledUniforms> {
  readonly reads = ['gbuffer', 'light-lists', 'overdraw'] as const;
  private lists: LightLists | null = null;
  private isLite = false;

  constructor() {
    const uniforms = { ...gbufferUniforms(), dfgLUT: { value: null } };
    super({ program: 'tiled output', fragment: 'tiledOutput', uniforms, fog: true });
  }

  protected read(frame: Frame): void {
    const gbuffer = frame.resources.get('gbuffer');
    setGBufferUniforms(this.uniforms, gbuffer, frame);
    const lists = frame.resources.get('light-lists');
    if (lists === this.lists && gbuffer.isLite === this.isLite) return;
    this.lists = lists;
    this.isLite = gbuffer.isLite;
    // gbufferRead comes first: the loop's lightImage expands FAROL_POSITION_AT, which gbufferRead defines
    this.recompose({
      fragment: ['gbufferRead', lists.loop, 'tiledOutput'],
      defines: { ...lists.defines, FAROL_ONE_TURN: '', ...(this.isLite && { FAROL_LITE: '' }) },
    });
  }
}
