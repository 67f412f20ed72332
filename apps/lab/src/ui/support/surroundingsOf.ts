import type { LabSurroundings } from '../../results/LabRun';
import { browserName } from './browserName';

/** Where a run is made, as the browser and the stage tell it. */
export function surroundingsOf(device: { renderer: string; software: boolean }): LabSurroundings {
  return {
    date: new Date().toISOString(),
    device: device.renderer,
    ...browserName(navigator.userAgent),
    cores: navigator.hardwareConcurrency ?? null,
    build: '0.1.0',
    versions: {},
    command: null,
    warnings: device.software
      ? ['Drawn on the processor by a software rasteriser: the figures say nothing about graphics cards.']
      : [],
  };
}
