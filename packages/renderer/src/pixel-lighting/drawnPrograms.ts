import type { Material } from 'three';
import type { Frame } from '../frame/Frame';
import type { DirectDraw } from '../three/directDraw';
import type { PixelProgram } from './PixelLighting';

interface Program {
  readonly vertexShader: WebGLShader;
  readonly fragmentShader: WebGLShader;
}

/** Line that a composed source has before each chunk. */
const MARK = /^\/\/ <([^/>][^>]*)>/gm;

/** Programs that a frame draws with while `draw` runs, and the microshaders in them. */
export function drawnPrograms(frame: Frame, draw: () => void): PixelProgram[] {
  const drawn = new Set<Material>();
  const own = frame as { draw: DirectDraw };
  const { draw: direct } = own;
  own.draw = (camera, scene, geometry, material, object, group) => {
    direct(camera, scene, geometry, material, object, group);
    drawn.add(material);
  };
  try {
    draw();
  } finally {
    own.draw = direct;
  }
  const { gl, webgl } = frame;
  const programs = new Map<Program, PixelProgram>();
  for (const material of drawn) {
    const { currentProgram } = webgl.properties.get(material) as { currentProgram?: Program };
    if (currentProgram === undefined || programs.has(currentProgram)) continue;
    const { vertexShader, fragmentShader } = currentProgram;
    const source = `${gl.getShaderSource(vertexShader)}\n${gl.getShaderSource(fragmentShader)}`;
    const names = [...source.matchAll(MARK)].map(([, name]) => name).filter((name) => !name.startsWith('three/'));
    programs.set(currentProgram, { name: material.name || material.type, microshaders: [...new Set(names)] });
  }
  return [...programs.values()];
}
