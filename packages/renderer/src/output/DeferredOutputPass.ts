import type { Texture } from 'three';
import type { Frame } from '../frame/Frame';
import { gbufferUniforms, setGBufferUniforms } from '../gbuffer/gbufferUniforms';
import { OutputPass } from './OutputPass';

const deferredUniforms = () => ({ ...gbufferUniforms(), farol_lightingMap: { value: null as Texture | null } });

/** Joins the G-buffer's accumulation and the sum of the lights. */
export class DeferredOutputPass extends OutputPass<ReturnType<typeof deferredUniforms>> {
  readonly reads = ['gbuffer', 'lighting', 'overdraw'] as const;

  constructor() {
    super({ program: 'deferred output', fragment: 'deferredOutput', uniforms: deferredUniforms(), fog: true });
  }

  protected read(frame: Frame): void {
    setGBufferUniforms(this.uniforms, frame.resources.get('gbuffer'), frame);
    this.uniforms.farol_lightingMap.value = frame.resources.get('lighting');
  }
}
