import type { TechniqueName } from '@farol/renderer';
import type * as Three from 'three';
import { checkAgreement } from '../support/agreement';
import type { Difference } from '../support/images';
import { expect, test } from '../support/benchTest';

/** Limits for shadows: texels at edges may differ. */
const SHADOWS = { largest: Infinity, psnr: 50, share: 0.006 };

test('cameras of other kinds: scaled, mirrored, sheared, without planes of their own, in arrays with layers', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(() => {
    const { Bench, compareImages, isFlat, isSlice, shadowScene, techniquesInTurn, three } = window.testPage;
    const width = 64;
    const height = 48;
    const bench = new Bench(width, height);
    bench.farol.inferredScale = 1;
    const names = techniquesInTurn(3);
    const found: (Difference & { name: string; technique: TechniqueName; flat: boolean })[] = [];
    const compare = (name: string, scene: Three.Scene, camera: Three.Camera) => {
      const stock = bench.stock(scene, camera);
      const flat = isFlat(stock);
      for (const technique of names)
        found.push({ name, technique, flat, ...compareImages(stock, bench.byTechnique(technique, scene, camera)) });
    };
    const make = (side: Three.Side = three.FrontSide) => {
      const scene = new three.Scene();
      scene.background = new three.Color(0x334455);
      const materials = [
        new three.MeshStandardMaterial({ color: 0xffccaa, roughness: 0.4, side }),
        new three.MeshPhongMaterial({ color: 0x88aaff, shininess: 40, side }),
        new three.MeshLambertMaterial({ color: 0x99ee99, side }),
      ];
      // in the slice all of the first kind: fewer programs
      const balls = materials.map((own, i) => {
        const material = isSlice ? materials[0] : own;
        const ball = new three.Mesh(new three.SphereGeometry(0.8, 24, 16), material);
        ball.position.set(i * 1.8 - 1.8, (i % 2) * 0.4, 0);
        const lamp = new three.PointLight(0xffffff, 6, 5);
        lamp.color.setHSL(i / 3, 0.6, 0.6);
        lamp.position.set(ball.position.x, 0.9, 1.6);
        scene.add(lamp);
        return ball;
      });
      const spot = new three.SpotLight(0xffffff, 40, 12, 0.5, 0.4);
      spot.position.set(2, 2, 4);
      const wall = new three.Mesh(new three.PlaneGeometry(9, 6), materials[0]);
      wall.position.z = -1;
      scene.add(wall, ...balls, spot, spot.target, new three.DirectionalLight(0xffeedd, 0.4));
      return { scene, balls, lamps: scene.children.filter((child) => child instanceof three.PointLight) };
    };
    const camera = () => {
      const one = new three.PerspectiveCamera(45, width / height, 0.5, 30);
      one.position.set(0.3, 0.4, 6);
      one.lookAt(0, 0, 0);
      one.updateMatrixWorld();
      return one;
    };

    // as mapping libraries have them: one matrix for all, which has no inverse and no planes beside it
    const whole = new three.Camera();
    const { projectionMatrix, matrixWorldInverse } = camera();
    whole.projectionMatrix.multiplyMatrices(projectionMatrix, matrixWorldInverse);
    compare('all in the projection', make().scene, whole);
    const bare = new three.Camera();
    bare.projectionMatrix.copy(projectionMatrix);
    bare.position.copy(camera().position);
    bare.quaternion.copy(camera().quaternion);
    compare('a projection without near and far', make().scene, bare);
    const skewed = camera();
    skewed.projectionMatrix.elements[4] = 0.3;
    compare('a skewed projection', make().scene, skewed);
    const cabinet = new three.OrthographicCamera(-3, 3, 2.2, -2.2, 0.5, 20);
    cabinet.position.z = 6;
    cabinet.projectionMatrix.multiply(new three.Matrix4().makeShear(0, 0, 0, 0, 0.2, 0.15));
    compare('an orthographic projection that shears', make().scene, cabinet);
    for (const [name, x, y] of [
      ['mirrored', -1, 1],
      ['upside down', 1, -1],
    ] as const) {
      const mirrored = camera();
      mirrored.projectionMatrix.premultiply(new three.Matrix4().makeScale(x, y, 1));
      compare(`a projection that is ${name}`, make(three.BackSide).scene, mirrored);
    }
    const far = new three.OrthographicCamera(-3, 3, 2.2, -2.2, 0.1, 1e6);
    far.position.z = 6;
    compare('orthographic, far plane at 1e6', make().scene, far);
    const before = new three.OrthographicCamera(-3, 3, 2.2, -2.2, -20, 20);
    compare('orthographic, with what lies behind it', make().scene, before);

    // three leaves the scale of a camera out of the view
    bench.webgl.shadowMap.enabled = true;
    for (const scale of [
      [2, 2, 2],
      [-1, 1.5, 0.5],
    ] as const) {
      const { scene, camera: seen } = shadowScene(width, height, { caster: 'mixed', few: isSlice });
      const rig = new three.Group();
      rig.scale.fromArray(scale);
      rig.add(seen);
      seen.position.divide(rig.scale);
      scene.add(rig);
      compare(`shadows, a camera scaled by ${scale.join()}`, scene, seen);
    }
    bench.webgl.shadowMap.enabled = false;

    // lights and things of one eye, as WebXR's cameras have them
    const { scene, balls, lamps } = make();
    lamps.forEach((lamp, i) => lamp.layers.set(i));
    balls.forEach((ball, i) => ball.layers.set(i));
    const eyes = [1, 2].map((layer, i) => {
      const eye = camera() as Three.PerspectiveCamera & { viewport: Three.Vector4 };
      eye.viewport = new three.Vector4((i * width) / 2, 0, width / 2, height);
      eye.layers.enable(layer);
      return eye;
    });
    const array = new three.ArrayCamera(eyes);
    array.copy(camera(), false);
    array.cameras = eyes;
    compare('an array that sees layer 0, its cameras more', scene, array);
    array.layers.mask = 7;
    compare('an array that sees the layers of all of its cameras', scene, array);
    return found;
  });
  for (const { name, technique, flat, ...difference } of results) {
    expect(flat, name).toBe(false);
    const buffers = /deferred|light-prepass|auto/.test(technique);
    const limit = name.startsWith('shadows') ? SHADOWS : buffers ? { psnr: 55, share: 0.001 } : {};
    checkAgreement(technique, difference, name, technique === 'inferred' ? {} : limit);
  }
});

test('levels of detail, their shadows and the order of what is transparent go by an array of cameras', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(() => {
    const { Bench, compareImages, techniquesInTurn, three } = window.testPage;
    const bench = new Bench(96, 48);
    bench.webgl.shadowMap.enabled = true;
    bench.farol.inferredScale = 1;
    const scene = new three.Scene();
    scene.background = new three.Color(0x334455);
    const levels = new three.LOD();
    const solid = new three.MeshLambertMaterial({ color: 0xffaa66 });
    [new three.SphereGeometry(0.7, 24, 16), new three.BoxGeometry(1.2, 1.2, 1.2)].forEach((geometry, i) => {
      const level = new three.Mesh(geometry, solid);
      level.castShadow = true;
      levels.addLevel(level, i * 6);
    });
    const floor = new three.Mesh(new three.PlaneGeometry(12, 12), new three.MeshLambertMaterial());
    floor.rotation.x = -Math.PI / 2;
    floor.position.y = -1;
    floor.receiveShadow = true;
    const panes = [0xff2200, 0x00ff22].map((color, i) => {
      const material = new three.MeshLambertMaterial({ color, transparent: true, opacity: 0.6 });
      const pane = new three.Mesh(new three.PlaneGeometry(1.2, 1.2), material);
      pane.position.set(1.4 + 0.2 * i, 0.2, 1 - 0.6 * i);
      return pane;
    });
    const sun = new three.DirectionalLight(0xffffff, 2);
    sun.position.set(1, 4, 2);
    sun.castShadow = true;
    scene.add(levels, floor, ...panes, sun);
    // one nearer than the distance of the second level, one on the other side of the panes
    const eyes = [
      [0, 0.5, 5],
      [1, 0.5, -6],
    ].map(([x, y, z], i) => {
      const eye = new three.PerspectiveCamera(50, 1, 0.5, 30) as Three.PerspectiveCamera & { viewport: Three.Vector4 };
      eye.position.set(x, y, z);
      eye.lookAt(0.5, 0, 0);
      eye.viewport = new three.Vector4(i * 48, 0, 48, 48);
      eye.updateMatrixWorld();
      return eye;
    });
    panes.forEach(({ material }) => (material.side = three.DoubleSide));
    const array = new three.ArrayCamera(eyes);
    array.position.set(0, 0.5, 6.5);
    array.projectionMatrix.copy(eyes[0].projectionMatrix);
    return techniquesInTurn(2).map((technique) => ({
      technique,
      ...compareImages(bench.stock(scene, array), bench.byTechnique(technique, scene, array)),
    }));
  });
  for (const { technique, ...difference } of results)
    checkAgreement(technique, difference, 'an array of cameras', SHADOWS);
});
