import { lightBufferCode } from './techniqueCode';
import type { Technique } from '../frame/Technique';

/**
 * Light pre-pass (deferred lighting): normals and specular lobes into a thin G-buffer, the lights into a light buffer with
 * diffuse and specular apart, then the materials once more, each lit by what the light buffer holds: any number of models.
 * @see Engel 2009, Designing a Renderer for Multiple Lights: The Light Pre-Pass Renderer (ShaderX7, 8.5),
 *   https://diaryofagraphicsprogrammer.blogspot.com/2008/03/light-pre-pass-renderer.html; thesis 2.2.3.3.2
 */
export const lightPrepass: Technique = {
  label: 'Light pre-pass',
  help: 'Normals, then the lights into a buffer, then the materials, lit by that buffer.',
  lightOrder: 'by-volume',
  needsFloatTargets: true,
  lazy: lightBufferCode,
  writes: ['scene-depth'],
  passes: () => lightBufferCode.required.lightPrepassPasses(),
};
