import { NO_LIGHT } from '../../lights/lightRecord';
import { DepthOrder } from '../../lights/DepthOrder';
import { type LightTable, QUAD } from '../../lighting/LightTable';

const depthOrder = new DepthOrder();

/** Orders the records of lights with a range near to far, plain point lights first; other lights begin with a new quad. */
export function rankByDepth(lights: LightTable): void {
  const { emissions, spheres } = lights;
  const count = lights.boundeds.length;
  const byDepth = depthOrder.sort(count, spheres, 4, 2);
  let plains = 0;
  for (let i = 0; i < count; i++) if (emissions[i * 4 + 3] >= 0) plains++;
  lights.plainQuads = Math.ceil(plains / QUAD);
  lights.bounded = plains === count ? count : lights.plainQuads * QUAD + count - plains;
  const order = lights.makeOrder(lights.bounded);
  order.fill(NO_LIGHT, plains, lights.bounded);
  let a = 0;
  let b = lights.plainQuads * QUAD;
  for (let k = 0; k < count; k++) {
    const i = byDepth[k];
    if (emissions[i * 4 + 3] >= 0) order[a++] = i;
    else order[b++] = i;
  }
}
