import type { LearntChoice } from '@farol/renderer';
import { formatCount, t, tCount } from '@farol/editing';
import { useCallback, useEffect, useRef, useState } from 'preact/hooks';
import type { LabCase } from '../plan/LabPlan';
import { planOf } from '../plan/planOf';
import { presets } from '../plan/presets';
import { messageOf } from '../run/messageOf';
import { competitorWord } from '../words/names';
import { deviceName } from '../words/device';
import type { StageState } from './support/useStage';

/** Cases in which `auto` learns: numbers of lights where it may be unsure; small pictures when the CPU draws. */
function casesFor(software: boolean): readonly LabCase[] {
  const { configuration } = presets.quick;
  const [scene, values] = software ? ['benchmarkLights', [4, 64]] : ['sponza', [2, 8, 32, 128, 512, 2000]];
  const series = [{ scene: scene as string, n: 15, axis: 'lights' as const, values: values as number[], lights: 0 }];
  const size = software ? { width: 128, height: 72 } : { width: 1280, height: 720 };
  return planOf({ ...configuration, ...size, series }).series[0].cases;
}

/** Button that lets `auto` learn on this device, the results, and a button that deletes them. */
export function Learning({ stage, isBusy }: { stage: StageState; isBusy: boolean }) {
  const [learnt, setLearnt] = useState<readonly LearntChoice[]>([]);
  const [share, setShare] = useState<number | null>(null);
  const [problem, setProblem] = useState<string | null>(null);
  const abort = useRef<AbortController | null>(null);
  const { device, frames } = stage;
  const refresh = useCallback(async () => {
    const opened = await frames().stageOf('auto');
    setLearnt((await opened.learnt?.()) ?? []);
  }, [frames]);
  useEffect(() => {
    if (device) refresh().catch((error: unknown) => setProblem(messageOf(error)));
    return () => abort.current?.abort();
  }, [device, refresh]);

  const attempt = async (act: () => Promise<void>): Promise<void> => {
    setProblem(null);
    try {
      await act();
      await refresh();
    } catch (error) {
      setProblem(messageOf(error));
    }
    setShare(null);
  };
  const learn = () =>
    attempt(async () => {
      const opened = await frames().stageOf('auto');
      const cases = casesFor(device?.software ?? false);
      abort.current = new AbortController();
      const { signal } = abort.current;
      setShare(0);
      for (const [done, labCase] of cases.entries()) {
        if (!signal.aborted) await opened.learn?.(labCase, signal, (part) => setShare((done + part) / cases.length));
      }
    });
  const clear = () => attempt(async () => (await frames().stageOf('auto')).clearLearnt?.());
  const canTime = device !== null && (device.timer || device.software);
  return (
    <section class="results learning" aria-labelledby="learning-title">
      <h2 id="learning-title">{t('What auto learnt on this device')}</h2>
      <p class="dim">
        {t(
          'The technique “auto” picks another one by rules from one GPU. Here it measures those that it hesitates between, and keeps in this browser which is faster: pages of this address with the option “learning” go by that.',
        )}
      </p>
      <div class="library-buttons">
        {share === null ? (
          <button type="button" disabled={isBusy || !canTime} onClick={() => void learn()}>
            {t('Let auto learn')}
          </button>
        ) : (
          <button type="button" onClick={() => abort.current?.abort()}>
            {t('Cancel')}
          </button>
        )}
        <button type="button" disabled={learnt.length === 0 || share !== null} onClick={() => void clear()}>
          {t('Forget all of it')}
        </button>
      </div>
      {share !== null && <progress value={share} max={1} aria-labelledby="learning-title" />}
      {device !== null && !canTime && (
        <p class="dim">{t('Nothing can be learnt here: the device has no GPU timer.')}</p>
      )}
      {problem && (
        <p class="problem" role="alert">
          {problem}
        </p>
      )}
      <p role="status">
        {learnt.length === 0 ? t('Nothing yet.') : tCount(learnt.length, '{count} verdict.', '{count} verdicts.')}
      </p>
      <ul>
        {learnt.map((choice) => (
          <li key={JSON.stringify(choice)}>{choiceText(choice)}</li>
        ))}
      </ul>
    </section>
  );
}

function choiceText({ gpu, techniques, faster, lights, coverage, pixels }: LearntChoice): string {
  const [a, b] = techniques.map(competitorWord);
  const where = t('{gpu}, from {lights} lights, {coverage} over a pixel, {pixels} pixels', {
    ...{ gpu: deviceName(gpu), lights: formatCount(lights), coverage, pixels: formatCount(pixels) },
  });
  const verdict =
    faster === null
      ? t('{a} and {b} are as fast', { a, b })
      : t('{a} is faster than {b}', faster === techniques[0] ? { a, b } : { a: b, b: a });
  return `${where}: ${verdict}.`;
}
