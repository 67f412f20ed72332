import { type Frame, FullscreenPass, type Pass, type Technique } from '@farol/renderer/authoring';
import { techniques } from '@farol/renderer';
import { MultiplyBlending, Vector2 } from 'three';
import lanternVignette from './vignette.glsl?raw';

const size = { value: new Vector2() };

/** Darkens the image towards its edges. */
class VignettePass extends FullscreenPass implements Pass {
  readonly name = 'vignette';
  readonly reads = [] as const;
  readonly writes = ['target'] as const;

  constructor() {
    super({
      program: 'lantern vignette',
      fragment: 'lanternVignette',
      microShaders: { lanternVignette },
      uniforms: { lantern_size: size },
      blending: MultiplyBlending,
      premultipliedAlpha: true,
    });
  }

  render(frame: Frame): void {
    if (frame.view !== 'final') return;
    size.value.set(frame.width, frame.height);
    frame.bindTarget();
    this.draw(frame);
  }
}

/** Tiled deferred shading, followed by a pass of the plugin. */
export const vignette: Technique = {
  ...techniques['tiled-deferred'],
  label: 'Vignette',
  help: 'Tiled deferred shading that grows dark towards the edges: an example of a plugin.',
  passes: () => [...techniques['tiled-deferred'].passes(), new VignettePass()],
};
