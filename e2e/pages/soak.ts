import { FarolRenderer } from '@farol/renderer';
import { Soak } from './soak/Soak';

declare global {
  interface Window {
    Soak: typeof Soak;
    soak: Soak;
  }
}

await FarolRenderer.preload();
window.Soak = Soak;
