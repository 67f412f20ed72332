import type { Device } from './support/useStage';

/** What the figures will be about: the device, the browser, and what spoils both. */
export function DeviceNote({ device, problem }: { device: Device | null; problem: string | null }) {
  return (
    <div class="device">
      <dl>
        <dt>Graphics</dt>
        <dd>{device ? device.name : problem ? 'unknown' : 'looking …'}</dd>
        <dt>Browser</dt>
        <dd>{device ? `${device.browser}, ${device.system}` : '…'}</dd>
        <dt>GPU time</dt>
        <dd>
          {device ? (device.timer ? 'by timer queries' : 'no timer: whole frames are measured') : problem ? '–' : '…'}
        </dd>
        <dt>WebGPU</dt>
        <dd>{device ? (device.webgpu ?? 'yes') : problem ? '–' : '…'}</dd>
      </dl>
      {device?.software && (
        <p class="warning">
          The browser draws on the processor here, by a software rasteriser, not on a graphics card: a run takes longer,
          and its figures say nothing about GPUs. Switch hardware acceleration on in the browser’s settings.
        </p>
      )}
      {problem && (
        <p class="problem" role="alert">
          {problem}
        </p>
      )}
    </div>
  );
}
