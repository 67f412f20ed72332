import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import type { Configuration } from '../plan/Configuration';
import { useOwnScene } from '../own/useOwnScene';
import { MOST_CONTEXTS } from '../plan/planOf';
import { presets } from '../plan/presets';
import type { LabRun } from '../results/LabRun';
import { surroundingsOf } from '../results/surroundings';
import { Hero } from './Hero';
import { Results } from './results/Results';
import { RunPanel } from './RunPanel';
import { Setup } from './Setup';
import { planned } from './support/planned';
import { useConfiguration } from './support/useConfiguration';
import { useRun } from './support/useRun';
import { useStage } from './support/useStage';
import { ThemeSelect } from './ThemeSelect';

/** The whole page. */
export function LabPage() {
  const { configuration, problems, setConfiguration } = useConfiguration();
  const [own, setOwn] = useState<LabRun | null>(null);
  const stage = useStage();
  const handed = useOwnScene();
  const { running, problem, start, cancel } = useRun();
  const isRunning = running !== null;
  const plan = useMemo(() => planned(configuration), [configuration]);

  const measure = async (wanted: Configuration): Promise<void> => {
    setConfiguration(wanted);
    const made = planned(wanted);
    if (!made.plan) return;
    const run = await start(made.plan, async () => {
      const frames = stage.frames();
      if (handed.scene) await frames.setOwnScene(handed.scene.file);
      const device = await (await frames.stageOf('forward')).device();
      return { frames, surroundings: await surroundingsOf(device), mostContexts: mostContexts() };
    });
    stage.close();
    if (run) setOwn(run);
  };

  const shown = running?.run ?? own;
  useFocusOnResults(own);
  return (
    <>
      <header class="bar">
        <p class="brand">Farol Lab</p>
        <ThemeSelect />
      </header>
      <main>
        <Hero stage={stage} isRunning={isRunning} onMeasure={() => void measure(presets.quick.configuration)} />
        {running && <RunPanel running={running} onCancel={cancel} />}
        {[...problems, ...(problem ? [problem] : []), ...(handed.problem ? [handed.problem] : [])].map((each) => (
          <p key={each} class="problem" role="alert">
            {each}
          </p>
        ))}
        {handed.scene && (
          <p role="status">
            Handed over, to be measured: <strong>{handed.scene.name}</strong>
          </p>
        )}
        <div class="columns">
          <Setup
            configuration={configuration}
            planned={plan}
            unavailable={stage.unavailable}
            ownScene={handed.scene?.name ?? null}
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

/** Moves the focus to the results of a run once it is over, since the button that cancels it is gone. */
function useFocusOnResults(run: LabRun | null): void {
  const before = useRef(run);
  useEffect(() => {
    if (run !== before.current) document.getElementById('results-title')?.focus();
    before.current = run;
  }, [run]);
}

/** Contexts that the browser keeps alive at once. */
function mostContexts(): number {
  return matchMedia('(pointer: coarse) and (width < 900px)').matches ? MOST_CONTEXTS.phone : MOST_CONTEXTS.desktop;
}
