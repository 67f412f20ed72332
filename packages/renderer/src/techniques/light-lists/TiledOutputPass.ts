import type { IUniform, Texture } from 'three';
import type { Frame } from '../../frame/Frame';
import { type GBufferUniforms, gbufferUniforms, setGBufferUniforms } from '../../passes/gbuffer/gbufferUniforms';
import type { LightLists } from '../../frame/LightLists';
import { OutputPass } from '../../passes/output/OutputPass';

interface TiledUniforms extends GBufferUniforms {
  dfgLUT: IUniform<Texture | null>;
}

/** Lights the G-buffer by the light lists, every pixel once. */
export class TiledOutputPass extends OutputPass<TiledUniforms> {
  readonly reads = ['gbuffer', 'light-lists', 'overdraw'] as const;
  private lists: LightLists | null = null;

  constructor() {
    const uniforms = { ...gbufferUniforms(), dfgLUT: { value: null } };
    super({ program: 'tiled output', fragment: 'tiledOutput', uniforms, fog: true });
  }

  protected read(frame: Frame): void {
    setGBufferUniforms(this.uniforms, frame.resources.get('gbuffer'), frame);
    const lists = frame.resources.get('light-lists');
    if (lists === this.lists) return;
    this.lists = lists;
    // gbufferRead comes first: the loop's lightImage expands FAROL_POSITION_AT, which gbufferRead defines
    this.recompose({
      fragment: ['gbufferRead', lists.loop, 'tiledOutput'],
      defines: { ...lists.defines, FAROL_ONE_TURN: '' },
    });
  }
}
