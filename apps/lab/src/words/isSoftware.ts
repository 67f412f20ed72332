import type { LabRun } from '../results/LabRun';

/** Whether a processor drew: times then rank the work of shading, not a GPU. */
export function isSoftware({ surroundings: { device } }: LabRun): boolean {
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(device);
}
