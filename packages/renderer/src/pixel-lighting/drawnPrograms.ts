import type { Material } from 'three';
import type { Frame } from '../frame/Frame';
import type { DirectDraw } from '../three/directDraw';
import { programHandle } from '../three/handles';
import type { PixelProgram } from './PixelLighting';

/** Matches the line before each chunk in a composed source. */
const MARK = /^\/\/ <([^/>][^>]*)>/gm;

/** Programs that a frame uses while `draw` runs, and their microshaders. */
export function drawnPrograms(frame: Frame, draw: () => void): PixelProgram[] {
  const drawn = new Set<Material>();
  const drawing = frame as { draw: DirectDraw };
  const { draw: direct } = drawing;
  drawing.draw = (camera, scene, geometry, material, object, group) => {
    direct(camera, scene, geometry, material, object, group);
    drawn.add(material);
  };
  try {
    draw();
  } finally {
    drawing.draw = direct;
  }
  const { gl, webgl } = frame;
  const programs = new Map<WebGLProgram, PixelProgram>();
  for (const material of drawn) {
    const program = programHandle(webgl, material);
    if (programs.has(program)) continue;
    const sources = gl.getAttachedShaders(program)!.map((shader) => gl.getShaderSource(shader));
    const names = [...sources.join('\n').matchAll(MARK)].map(([, name]) => name);
    const own = new Set(names.filter((name) => !name.startsWith('three/')));
    programs.set(program, { name: material.name || material.type, microshaders: [...own] });
  }
  return [...programs.values()];
}
