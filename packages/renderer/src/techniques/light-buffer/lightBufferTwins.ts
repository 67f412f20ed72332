import type { IUniform } from 'three';
import { forwardTwins, type ForwardTwins } from '../../materials/forwardTwin';
import { withObject } from './objectAttribute';
import type { TwinKind } from '../../materials/TwinKind';

/**
 * Makes twins of lit materials that read their direct light from the light buffer.
 * @param uniforms - uniforms of lightBufferFilter.glsl
 */
export function lightBufferTwins(uniforms: Record<string, IUniform>): (view: string) => ForwardTwins {
  return forwardTwins('lightLoopBuffer', (kind: TwinKind) =>
    withObject({
      ...kind,
      role: 'light-buffer',
      patch(shader, source, header) {
        kind.patch(shader, source, header);
        Object.assign(shader.uniforms, uniforms);
      },
    }),
  );
}
