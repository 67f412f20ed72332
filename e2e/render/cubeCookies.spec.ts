import type { CheckedSampling } from '../pages/checkedMap';
import { expectAsMeasured } from '../support/agreement';
import { test } from '../support/benchTest';

/**
 * The cube that a point light throws, beside stock three's picture of six spot lights that throw its faces: each lights a
 * disk that lies in its cone, and in no other's (dB, by forward techniques and by those with a G-buffer). On
 * a GPU, whose own filters the copy of a cube follows by formulas, as measured on an H100.
 */
const samplings: readonly (CheckedSampling & {
  name: string;
  measured: readonly [number, number];
  onGPU?: readonly [number, number];
})[] = [
  { name: 'mipmaps', min: 'LinearMipmapLinear', measured: [57, 45], onGPU: [42.6, 41.3] },
  { name: 'mipmaps, anisotropy', min: 'LinearMipmapLinear', anisotropy: 8, measured: [47, 43], onGPU: [35, 35] },
  { name: 'the nearest mipmap', min: 'LinearMipmapNearest', measured: [47, 43], onGPU: [35.5, 35.4] },
  { name: 'linear, without mipmaps', min: 'Linear', side: 9, measured: [55, 55], onGPU: [50.6, 50.5] },
  { name: 'the nearest texel', min: 'Nearest', mag: 'Nearest', side: 9, measured: [39, 30], onGPU: [29, 22] },
];

/** The nearest mipmap: cookies.spec.ts has the others. */
const IN_SLICE = 2;

for (const [turn, { name, measured, onGPU = measured, ...sampling }] of samplings.entries()) {
  const least = process.env.FAROL_GPU ? onGPU : measured;
  test(`the cube that a point light throws is filtered as spot lights' maps are: ${name}${turn === IN_SLICE ? '' : ' @verify'}`, async ({
    benchPage: page,
  }) => {
    const pairs = await page.evaluate(
      ({ turn, sampling }) => {
        const { Bench, checkedMap, compareImages, setLightOptions, techniquesInTurn, three } = window.testPage;
        const bench = new Bench(128, 96);
        bench.farol.inferredScale = 1;
        // an odd number of checks is the same from all sides
        const faces = Array.from({ length: 6 }, () => checkedMap({ side: 63, ...sampling }));
        const stockScene = new three.Scene();
        const scene = new three.Scene();
        const axes = [0, 1, 2].flatMap((axis) => [1, -1].map((side) => new three.Vector3().setComponent(axis, side)));
        const material = new three.MeshLambertMaterial();
        for (const [i, axis] of axes.entries()) {
          const disk = new three.Mesh(new three.CircleGeometry(3.9, 48), material);
          disk.position.copy(axis).multiplyScalar(4);
          disk.lookAt(0, 0, 0);
          scene.add(disk);
          stockScene.add(disk.clone());
          const spot = new three.SpotLight(0xffffff, 60, 0, Math.PI / 4);
          spot.position.set(0, 0, 0);
          spot.target.position.copy(axis);
          spot.map = faces[i];
          stockScene.add(spot, spot.target);
        }
        const point = new three.PointLight(0xffffff, 60);
        const [{ colorSpace, minFilter, magFilter, generateMipmaps, anisotropy }] = faces;
        const cookie = new three.CubeTexture(faces as unknown as HTMLImageElement[]);
        Object.assign(cookie, { colorSpace, minFilter, magFilter, generateMipmaps, anisotropy, needsUpdate: true });
        setLightOptions(point, { cookie });
        scene.add(point);
        const camera = new three.PerspectiveCamera(75, 4 / 3, 0.1, 30);
        return [1, -1].flatMap((side) => {
          camera.position.set(side * -2.6, side * -2, side * -3);
          camera.lookAt(side * 3, side, side * 2.2);
          const stock = bench.stock(stockScene, camera);
          return techniquesInTurn(turn).map((technique) => ({
            technique,
            ...compareImages(stock, bench.byTechnique(technique, scene, camera)),
          }));
        });
      },
      { turn, sampling },
    );
    for (const { technique, psnr } of pairs)
      expectAsMeasured(psnr, least[technique.includes('forward') ? 0 : 1], `${name}, ${technique}`);
  });
}
