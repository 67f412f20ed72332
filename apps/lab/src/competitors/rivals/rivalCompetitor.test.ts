import { BoxGeometry, DirectionalLight, Mesh, MeshStandardMaterial, PerspectiveCamera, PointLight, Scene } from 'three';
import { describe, expect, it } from 'vitest';
import type { StageScene } from '../../stage/StageScene';
import { rivalCompetitor } from './rivalCompetitor';
import type { RivalDrawing, RivalModule, RivalPoints, RivalScene } from './RivalScene';

const none = async () => ({ versions: {}, canInstall: false });

/** An engine that records its calls. */
function notingEngine() {
  const said: string[] = [];
  let scene: RivalScene | null = null;
  const numbers = ({ positions }: RivalPoints): string => [...positions].join(' ');
  const drawing: RivalDrawing = {
    gl: { linkProgram() {} } as unknown as WebGL2RenderingContext,
    drawFirst: async () => void said.push(`first ${numbers(scene!.points)}`),
    render: () => void said.push('render'),
    moveCamera: () => void said.push('camera'),
    moveMesh: (mesh) => void said.push(`mesh ${mesh} to ${scene!.meshes[mesh].placement[0]}`),
    moveLights: (points) => void said.push(`lights ${numbers(points)}`),
    setLights: (points) => void said.push(`${points.count} lights ${numbers(points)}`),
    moveInstances: () => {},
    dropped: () => 3,
    dispose: () => void said.push('dispose'),
  };
  const module: RivalModule = { version: '1', open: (_, described) => ((scene = described), drawing) };
  return { said, load: async () => module };
}

function stage(): StageScene & { lights: PointLight[]; box: Mesh; sun: DirectionalLight } {
  const three = new Scene();
  const lights = [new PointLight(0xffffff, 1, 5)];
  const sun = new DirectionalLight();
  const box = new Mesh(new BoxGeometry(), new MeshStandardMaterial());
  box.matrixAutoUpdate = false;
  three.add(...lights, sun, box);
  const camera = new PerspectiveCamera();
  const still = [sun];
  const parts = {
    three,
    camera,
    lights,
    still,
    width: 8,
    height: 8,
    setTime() {},
    addLights: () => () => {},
    box,
    sun,
  };
  return { ...parts, kind: 'points', shading: 'own', emitter: null };
}

const signal = new AbortController().signal;
const canvas = {} as HTMLCanvasElement;

describe('another engine', () => {
  it.each(['playcanvas', 'babylon'] as const)('%s says how it is installed when it is missing', async (name) => {
    const rival = rivalCompetitor(name, { installed: none });
    expect(await rival.unavailable()).toMatch(/^(PlayCanvas|Babylon\.js) is not installed: run npm run rivals, then/);
  });

  it('is there when its module is', async () => {
    const installed = async () => ({ versions: { playcanvas: '2.23.3' }, canInstall: true });
    expect(await rivalCompetitor('playcanvas', { installed }).unavailable()).toBeNull();
    expect(await rivalCompetitor('babylon', { installed }).unavailable()).toMatch(/is not installed/);
  });

  it('refuses shadows, other lights than points and Gouraud shading in a sentence', () => {
    const rival = rivalCompetitor('babylon', { installed: none });
    const scene = { lights: 5, shadows: 0, kind: 'points', shading: 'own' } as const;
    expect(rival.refuses({ ...scene, shadows: 1 })).toMatch(/without shadows/);
    expect(rival.refuses({ ...scene, kind: 'rectangles' })).toBe(
      'Babylon.js is measured with point lights alone, not with rectangles.',
    );
    expect(rival.refuses({ ...scene, shading: 'gouraud' })).toBe('The Lab has no Gouraud shading for Babylon.js.');
    expect(rival.refuses({ ...scene, shading: 'flat' })).toBeNull();
    expect(rival.refuses(scene)).toBeNull();
  });

  it('is told what moved once it has its scene, and takes what moved before with it', async () => {
    const { said, load } = notingEngine();
    const scene = stage();
    const drawing = await rivalCompetitor('playcanvas', { load }).open(canvas, scene, signal, 1000);
    scene.lights[0].position.set(1, 2, 3);
    drawing.lightsMoved?.();
    await drawing.drawFirst?.();
    expect(said).toEqual(['first 1 2 3']);
    scene.lights[0].position.set(4, 5, 6);
    scene.box.matrix.makeTranslation(7, 0, 0);
    scene.box.matrixWorldNeedsUpdate = true;
    scene.camera.position.x = 2;
    drawing.lightsMoved?.();
    drawing.render();
    expect(said.splice(1)).toEqual(['lights 4 5 6', 'mesh 0 to 7', 'camera', 'render']);
    drawing.lightsMoved?.();
    expect(said.splice(1)).toEqual(['lights 4 5 6']);
    expect(drawing.dropped?.()).toBe(3);
    drawing.dispose();
    expect(said).toContain('dispose');
  });

  it('gets lights that are added', async () => {
    const { said, load } = notingEngine();
    const scene = stage();
    const drawing = await rivalCompetitor('playcanvas', { load }).open(canvas, scene, signal, 1000);
    await drawing.drawFirst?.();
    const more = new PointLight(0xffffff, 1, 5);
    more.position.set(9, 9, 9);
    scene.three.add(more);
    scene.lights.push(more);
    drawing.lightsChanged?.();
    drawing.lightsMoved?.();
    expect(said.slice(1)).toEqual(['2 lights 0 0 0 9 9 9', 'lights 0 0 0 9 9 9']);
  });

  it('is not drawn with a light where it is not', async () => {
    const { load } = notingEngine();
    const scene = stage();
    const drawing = await rivalCompetitor('playcanvas', { load }).open(canvas, scene, signal, 1000);
    await drawing.drawFirst?.();
    scene.sun.position.x += 1;
    expect(() => drawing.lightsMoved?.()).toThrow(/may move: the Lab cannot/);
  });
});
