import { t } from '@farol/editing';
import { deviceName } from '../words/device';
import type { StageState } from './support/useStage';

/** The device and the browser of a run, with warnings. */
export function DeviceNote({ device, problem, unavailable }: StageState) {
  const waiting = problem ? 'unknown' : '…';
  const webgpu = unavailable['three-webgpu'];
  return (
    <div class="device">
      <dl>
        <dt>{t('Graphics')}</dt>
        <dd title={device?.surroundings.device}>{device ? deviceName(device.surroundings.device) : waiting}</dd>
        <dt>{t('Browser')}</dt>
        <dd>{device ? `${device.surroundings.browser}, ${device.surroundings.system}` : waiting}</dd>
        <dt>{t('GPU times')}</dt>
        <dd>
          {device ? (device.timer ? t('by timer queries') : t('no timer here: whole frames are measured')) : waiting}
        </dd>
        <dt>{t('WebGPU')}</dt>
        <dd>{webgpu === undefined ? waiting : webgpu === null ? t('yes') : t('no')}</dd>
      </dl>
      {device?.software && (
        <p class="warning">
          {t(
            'The browser draws on the processor here, by a software rasteriser, not on a graphics card: the button measures small pictures, and the figures say nothing about GPUs. Switch hardware acceleration on in the browser’s settings.',
          )}
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
