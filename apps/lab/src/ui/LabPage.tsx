import { useMemo, useState } from 'preact/hooks';
import type { LabRun } from '../results/LabRun';
import { presets } from '../plan/presets';
import type { Configuration } from '../plan/Configuration';
import { MOST_CONTEXTS } from '../plan/planOf';
import { Hero } from './Hero';
import { Results } from './results/Results';
import { RunPanel } from './RunPanel';
import { Setup } from './Setup';
import { surroundingsOf } from './support/surroundingsOf';
import { planned } from './support/planned';
import { useRun } from './support/useRun';
import { useStage } from './support/useStage';
import { ThemeSelect } from './ThemeSelect';

/** The whole page. */
export function LabPage() {
  const [configuration, setConfiguration] = useState<Configuration>(presets.quick.configuration);
  const [own, setOwn] = useState<LabRun | null>(null);
  const stage = useStage();
  const { running, problem, start, cancel } = useRun();
  const isRunning = running !== null;
  const plan = useMemo(() => planned(configuration), [configuration]);

  const measure = async (wanted: Configuration): Promise<void> => {
    setConfiguration(wanted);
    const made = planned(wanted);
    if (!made.plan) return;
    const run = await start(made.plan, async () => {
      const frames = stage.frames();
      const device = await (await frames.stageOf('forward')).device();
      return { frames, surroundings: surroundingsOf(device), mostContexts: MOST_CONTEXTS.desktop };
    });
    stage.close();
    if (run) setOwn(run);
  };

  const shown = running?.run ?? own;
  return (
    <>
      <header class="bar">
        <p class="brand">Farol Lab</p>
        <ThemeSelect />
      </header>
      <main>
        <Hero
          device={stage.device}
          problem={stage.problem}
          isRunning={isRunning}
          onMeasure={() => void measure(presets.quick.configuration)}
        />
        {running && <RunPanel running={running} onCancel={cancel} />}
        {problem && (
          <p class="problem" role="alert">
            {problem}
          </p>
        )}
        <div class="columns">
          <Setup
            configuration={configuration}
            planned={plan}
            unavailable={stage.unavailable}
            ownScene={null}
            isRunning={isRunning}
            onChange={setConfiguration}
            onMeasure={() => void measure(configuration)}
          />
          <section class="results" aria-labelledby="results-title">
            {shown ? (
              <Results run={shown} isReference={false} isRunning={isRunning} actions={null}>
                <p class="dim">The charts come here.</p>
              </Results>
            ) : (
              <h2 id="results-title">Results</h2>
            )}
          </section>
        </div>
      </main>
    </>
  );
}
