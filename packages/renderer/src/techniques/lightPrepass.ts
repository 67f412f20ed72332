import { lightBufferCode } from './techniqueCode';
import type { Technique } from '../frame/Technique';

/**
 * Light pre-pass (deferred lighting): normals and specular lobes are drawn to a thin G-buffer, lights to a light buffer with
 * separate diffuse and specular, then materials are drawn again, lit by the light buffer, so that any number of shading models
 * works.
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
