import { FarolRenderer } from '@farol/renderer';

/**
 * Fetches the renderer's late code before a module runs, so that its first frame is drawn as it stays: without it, a first
 * frame is drawn by other programs, which takes a software rasteriser seconds. Node materials and XR sessions come when asked
 * for.
 */
export const preloadRenderer = (): Promise<void> =>
  FarolRenderer.preload(FarolRenderer.parts.filter((part) => part !== 'nodes' && part !== 'webxr'));
