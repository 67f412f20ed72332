import {
  type FarolEffect,
  type Frame,
  FullscreenPass,
  setUnprojectUniforms,
  unprojectUniforms,
} from '@farol/renderer/authoring';
import { NormalBlending, type Texture, Vector2 } from 'three';
import distanceFade from './distanceFade.glsl?raw';

/** Lays a colour over what is far away, by every technique that hands over depth. */
export class DistanceFade implements FarolEffect {
  readonly name = 'distance fade';
  readonly bytes = 0;
  /** Distances (m) at which the fade begins, and at which it covers everything. */
  readonly range = new Vector2(4, 12);
  private readonly pass = new FullscreenPass({
    program: 'distance fade',
    fragment: 'distanceFade',
    microShaders: { distanceFade },
    shared: ['farol_offset'],
    uniforms: {
      ...unprojectUniforms(),
      example_depth: { value: null as Texture | null },
      example_range: { value: this.range },
    },
    transparent: true,
    blending: NormalBlending,
  });

  end(frame: Frame): void {
    const depth = frame.resources.find('scene-depth');
    if (depth === undefined) return;
    setUnprojectUniforms(this.pass.uniforms, frame.camera, frame.webgl);
    this.pass.uniforms.example_depth.value = depth;
    frame.bindTarget();
    this.pass.draw(frame);
  }

  dispose(): void {
    this.pass.dispose();
  }
}
