import { t, tCount } from '@farol/editing';
import { type ReactNode, useCallback, useMemo } from 'react';
import { bakedLightOf, type BakeState, type LightBaker, lightBakerOf } from '../../files/bake/LightBaker';
import { bakeLights, countForBake, lightsInPlace, objectsInPlace } from '../../model/bakeEdits';
import { setStatic } from '../../model/edits';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';
import { usePoll } from '../../ui/usePoll';
import { FieldList } from '../inspector/FieldList';
import '../inspector/inspector.css';
import { Section } from '../inspector/Section';
import './bake.css';
import { Button } from '../../ui/Button';

const lightmaps = [
  ...['bakeSize', 'bakeTexelsPerMetre', 'bakeBounces', 'bakeSamples'],
  ...['bakeSky', 'bakeDenoise', 'bakeStitch'],
];
const probes = ['bakeProbes', 'bakeProbeSpacing'];

/** Bakes light into lightmaps and probes: sources, quality, progress and result. */
export function BakePanel(): ReactNode {
  const editor = useEditor();
  const { document } = editor;
  const baker = lightBakerOf(editor);
  useSignal(document.opened);
  useSignal(document.assetsChanged);
  useSignal(document.simulation.changed);
  useSignal(baker.changed);
  const { settings } = document.scene;
  const owners = useMemo(() => [settings], [settings]);
  const { state } = baker;
  return (
    <section className="panel" aria-label={t('Baked light')}>
      <div className="inspector-body">
        <div className="bake-head">
          <Sources isRunning={state !== null} />
          {state ? <Running baker={baker} state={state} /> : <Buttons baker={baker} />}
          <Result baker={baker} />
        </div>
        <fieldset className="bake-fields" disabled={state !== null}>
          <Section id="Lightmaps" title={t('Lightmaps')} help={t('How finely light is baked on surfaces.')} icon="lamp">
            <FieldList owners={owners} names={lightmaps} />
          </Section>
          <Section
            id="Light probes"
            title={t('Light probes')}
            help={t('They give baked light to objects that are not static.')}
            icon="ranges"
          >
            <FieldList owners={owners} names={probes} />
          </Section>
        </fieldset>
      </div>
    </section>
  );
}

/** Numbers of objects and lights to bake, with a remedy when there are none. */
function Sources({ isRunning }: { isRunning: boolean }): ReactNode {
  const editor = useEditor();
  const { document, commands } = editor;
  const { scene } = document;
  // the counts are not updated during a bake, which replaces meshes of the scene
  const counts = usePoll(
    useCallback(() => countForBake(document.scene).join(), [document]),
    isRunning ? 0 : 2,
  );
  const [objects, lights, instanced, canBeStatic, canBeBaked] = counts.split(',').map(Number);
  return (
    <>
      <p className="bake-sources">
        {tCount(objects, '{count} static object', '{count} static objects')},{' '}
        {tCount(lights, '{count} baked light', '{count} baked lights')}
      </p>
      {!isRunning && objects === 0 && (
        <Mend
          text={t('Nothing is static: switch on Static for objects that do not move.')}
          action={
            canBeStatic > 0 ? tCount(canBeStatic, 'Make {count} object static', 'Make {count} objects static') : null
          }
          onMend={() => commands.run(setStatic(objectsInPlace(scene), true))}
        />
      )}
      {!isRunning && lights === 0 && (
        <Mend
          text={t('No light is baked: set the mode of lights to Baked.')}
          action={
            canBeBaked > 0 ? tCount(canBeBaked, 'Set {count} light to Baked', 'Set {count} lights to Baked') : null
          }
          onMend={() => commands.run(bakeLights(lightsInPlace(scene)))}
        />
      )}
      {instanced > 0 && (
        <p className="bake-note">
          {t('{count} instanced objects have no lightmap: probes light them.', { count: instanced })}
        </p>
      )}
    </>
  );
}

interface MendProps {
  readonly text: string;
  /** Label of a button that solves the problem; null for none. */
  readonly action: string | null;
  onMend(): void;
}

function Mend({ text, action, onMend }: MendProps): ReactNode {
  const editor = useEditor();
  return (
    <div className="bake-warning" role="note">
      <Icon name="warning" size={14} />
      <span>{text}</span>
      {action && <Button look="small framed" label={action} onClick={() => editor.attempt(onMend)} />}
    </div>
  );
}

function Buttons({ baker }: { baker: LightBaker }): ReactNode {
  const editor = useEditor();
  const { scene, simulation } = editor.document;
  const isPlaying = simulation.state !== 'stopped';
  return (
    <div className="bake-buttons">
      <Button
        look="primary"
        label={t('Bake')}
        disabled={isPlaying}
        title={isPlaying ? t('The scene is playing: stop it to bake its light.') : undefined}
        onClick={() => editor.attempt(() => baker.bake())}
      />
      <Button
        label={t('Clear')}
        disabled={scene.settings.bakedLight === null || isPlaying}
        onClick={() => editor.attempt(() => baker.clear())}
      />
    </div>
  );
}

const stageText = (stage: BakeState['stage']): string =>
  ({
    unwrapping: t('Unfolding surfaces'),
    preparing: t('Preparing'),
    tracing: t('Tracing light'),
    finishing: t('Finishing'),
    saving: t('Packing'),
  })[stage];

/** Text of the remaining time. @param seconds - rounded, at least 1 */
function timeText(seconds: number): string {
  const whole = Math.max(1, Math.round(seconds));
  return whole < 60
    ? t('{seconds} s left', { seconds: whole })
    : t('{minutes} min {seconds} s left', { minutes: Math.floor(whole / 60), seconds: whole % 60 });
}

function Running({ baker, state }: { baker: LightBaker; state: BakeState }): ReactNode {
  const { share, stage, samples, secondsLeft } = state;
  return (
    <div className="bake-running">
      <progress className="progress" aria-label={t('Baking')} value={share} max={1} />
      <span className="bake-stage">
        {stageText(stage)}
        {stage === 'tracing' && samples > 0 && ` · ${t('{count} samples', { count: samples })}`}
      </span>
      <span className="bake-time">
        {Math.floor(100 * share)} %{secondsLeft !== null && ` · ${timeText(secondsLeft)}`}
      </span>
      <Button label={t('Cancel')} onClick={() => baker.cancel()} />
    </div>
  );
}

const sizeText = (bytes: number): string =>
  bytes < 1e6
    ? t('{kilobytes} kB', { kilobytes: Math.ceil(bytes / 1e3) })
    : t('{megabytes} MB', { megabytes: (bytes / 1e6).toFixed(1) });

/** The baked light, and whether it is up to date with the scene. */
function Result({ baker }: { baker: LightBaker }): ReactNode {
  const { document } = useEditor();
  const isOutOfDate = usePoll(
    useCallback(() => (baker.state === null && baker.isOutOfDate ? 1 : 0), [baker]),
    2,
  );
  const { scene } = document;
  const { bakedLight } = scene.settings;
  const baked = bakedLightOf(scene);
  if (bakedLight === null || baked === null) return null;
  const { lightmaps, meshes, probes } = baked.data;
  const size = scene.assets.fileOf(bakedLight)?.size ?? 0;
  const count = probes ? probes.box.counts[0] * probes.box.counts[1] * probes.box.counts[2] : 0;
  const lines = [
    lightmaps.map(({ width, height }) => `${width} × ${height}`).join(', '),
    tCount(meshes.length, '{count} mesh', '{count} meshes'),
    tCount(count, '{count} light probe', '{count} light probes'),
    sizeText(size),
  ];
  return (
    <div className="bake-result">
      <p>
        <Icon name="check" size={12} /> {lines.filter(Boolean).join(' · ')}
      </p>
      {isOutOfDate === 1 && (
        <p className="bake-out-of-date" role="status">
          <Icon name="warning" size={14} /> {t('Out of date: something that was baked has changed. Bake again.')}
        </p>
      )}
    </div>
  );
}
