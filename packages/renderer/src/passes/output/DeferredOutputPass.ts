import type { IUniform, Texture } from 'three';
import type { Frame } from '../../frame/Frame';
import { type GBufferUniforms, gbufferUniforms, setGBufferUniforms } from '../gbuffer/gbufferUniforms';
import { OutputPass } from './OutputPass';

interface DeferredUniforms extends GBufferUniforms {
  farol_lightingMap: IUniform<Texture | null>;
}

/** Writes the G-buffer's accumulated light plus the sum of the lights. */
export class DeferredOutputPass extends OutputPass<DeferredUniforms> {
  readonly reads = ['gbuffer', 'lighting', 'overdraw'] as const;

  constructor() {
    const uniforms = { ...gbufferUniforms(), farol_lightingMap: { value: null } };
    super({ program: 'deferred output', fragment: 'deferredOutput', uniforms, fog: true });
  }

  protected read(frame: Frame): void {
    setGBufferUniforms(this.uniforms, frame.resources.get('gbuffer'), frame);
    this.uniforms.farol_lightingMap.value = frame.resources.get('lighting');
  }
}
