import { FarolRenderer } from '@farol/renderer';
import { BakeBench } from './bake/BakeBench';

declare global {
  interface Window {
    BakeBench: typeof BakeBench;
    bakeBench: BakeBench;
  }
}

await FarolRenderer.preload();
window.BakeBench = BakeBench;
