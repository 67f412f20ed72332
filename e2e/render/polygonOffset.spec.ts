import type { TechniqueName } from '@farol/renderer';
import { expect, test } from '../support/benchTest';

/**
 * Nothing hides anything else by its offset here, so that the picture is that without one, and as near to stock three's: edges
 * of shadows and highlights along a floor seen at a flat angle are some dB off by a G-buffer in either.
 */

/** Offset of a material's depth, and what else a case has. */
interface Case {
  readonly name: string;
  readonly factor: number;
  readonly units: number;
  readonly fog?: boolean;
  readonly reversed?: boolean;
}

const cases: readonly Case[] = [
  { name: 'factor 1', factor: 1, units: 0 },
  { name: 'factor 2, units 4, fog', factor: 2, units: 4, fog: true },
  { name: 'units 40,000', factor: 0, units: 40_000 },
  { name: 'factor -2, units -4, reversed depth', factor: -2, units: -4, reversed: true },
];

for (const [turn, { name, ...options }] of cases.entries()) {
  test(`surfaces by polygonOffset are lit where they are, ${name}${turn === 1 ? '' : ' @verify'}`, async ({
    benchPage: page,
  }) => {
    const { pairs, matters } = await page.evaluate(
      ({ turn, factor, units, fog, reversed }) => {
        const { Bench, compareImages, techniquesInTurn, three } = window.testPage;
        const [width, height] = [128, 96];
        const bench = new Bench(width, height, reversed ? { renderer: { reversedDepthBuffer: true } } : {});
        bench.webgl.shadowMap.enabled = true;
        bench.farol.inferredScale = 1;
        const offset = { polygonOffset: true, polygonOffsetFactor: factor, polygonOffsetUnits: units };
        const materials = [
          new three.MeshLambertMaterial(offset),
          new three.MeshStandardMaterial({ ...offset, roughness: 0.4 }),
        ];
        const scene = new three.Scene();
        if (fog) scene.fog = new three.Fog(0x668899, 2, 14);
        const floor = new three.Mesh(new three.PlaneGeometry(60, 60), materials[0]);
        floor.rotation.x = -Math.PI / 2;
        const box = new three.Mesh(new three.BoxGeometry(1, 1, 1), materials[1]);
        box.position.set(-0.8, 0.5, 0);
        box.castShadow = true;
        const ball = new three.Mesh(new three.SphereGeometry(0.5, 24, 16), new three.MeshPhongMaterial());
        ball.position.set(0.9, 0.5, -0.4);
        ball.castShadow = true;
        for (const mesh of [floor, box, ball]) mesh.receiveShadow = true;
        // small ones beside each other along the floor, and a spot light that casts shadows
        for (let i = 0; i < 12; i++) {
          const point = new three.PointLight(0xffaa88, 3, 1.5);
          point.position.set((i % 3) - 1, 0.5, 1.5 - 2 * Math.floor(i / 3));
          scene.add(point);
        }
        const spot = new three.SpotLight(0x88aaff, 60, 12, 0.5, 0.5);
        spot.position.set(2, 4, 2);
        spot.castShadow = true;
        spot.shadow.bias = -0.002;
        spot.shadow.mapSize.set(256, 256);
        scene.add(floor, box, ball, spot, spot.target);
        // along the floor, so that depth changes much from pixel to pixel
        const camera = new three.PerspectiveCamera(50, width / height, 0.1, 60);
        camera.position.set(0, 0.7, 4);
        camera.lookAt(0, 0.3, 0);
        const stock = bench.stock(scene, camera);
        const draw = (technique: TechniqueName) => {
          const image = bench.byTechnique(technique, scene, camera);
          // maps at rest, whose depths are bounded, come after some frames
          for (let i = 0; i < 4; i++) bench.byTechnique(technique, scene, camera);
          const rested = bench.byTechnique(technique, scene, camera);
          return [image, rested].map((one) => compareImages(stock, one));
        };
        const shift = (is: boolean) => {
          for (const material of materials) material.polygonOffset = is;
        };
        const pairs = techniquesInTurn(turn).map((technique) => {
          shift(true);
          const by = draw(technique);
          shift(false);
          return { technique, by, without: draw(technique) };
        });
        spot.castShadow = false;
        return { pairs, matters: compareImages(stock, bench.stock(scene, camera)).psnr };
      },
      { turn, ...options },
    );
    expect(matters, 'the shadow is to be seen').toBeLessThan(40);
    for (const { technique, by, without } of pairs) {
      for (const [i, { psnr, share }] of by.entries()) {
        const said = `${technique}: ${psnr.toFixed(1)} dB, ${without[i].psnr.toFixed(1)} without an offset`;
        test.info().annotations.push({ type: 'agreement', description: said });
        expect.soft(psnr, said).toBeGreaterThan(Math.min(without[i].psnr, 72) - 0.5);
        expect.soft(share, said).toBeLessThan(without[i].share + 5e-4);
      }
    }
  });
}
