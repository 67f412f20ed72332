import { t } from '@farol/editing';
import { effectFields, type SceneSettings } from '@farol/engine';
import { type ReactNode, useMemo } from 'react';
import { FieldList } from './FieldList';
import { Section } from './Section';
import { TechniqueLimit } from './TechniqueLimit';

const sky = [
  ...[
    'background',
    'backgroundColour',
    'sky',
    'placeSun',
    'sunAzimuth',
    'sunElevation',
    'skyTop',
    'skyHorizon',
    'skyGround',
    'environment',
    'skyLight',
  ],
  ...['environmentIntensity', 'backgroundIntensity', 'backgroundRotation', 'backgroundBlur'],
];
const fog = ['fog', 'fogFromSky', 'fogColour', 'fogNear', 'fogFar', 'fogDensity'];
const picture = [
  ...['technique', 'quality', 'antialiasing', 'frameBudget', 'toneMapping'],
  ...['exposureBy', 'exposure', 'exposureValue', 'aperture', 'shutterTime', 'iso'],
  ...['exposureLeast', 'exposureMost', 'exposureTime'],
  ...Object.keys(effectFields),
];
const shadows = ['shadowKind', 'shadowSoftness', 'shadowCascades'];
const effects = [
  ...['bloom', 'bloomIntensity', 'bloomThreshold', 'bloomRadius'],
  ...['depthOfField', 'focusDistance', 'focusRange', 'focusBlur'],
  ...['grading', 'temperature', 'tint', 'contrast', 'saturation', 'lut', 'lutStrength'],
  ...['vignette', 'vignetteDarkness', 'vignetteSize'],
];

/** Rendering settings of the scene. A feature that is off shows only its switch. */
export function PictureSections({ settings }: { settings: SceneSettings }): ReactNode {
  const owners = useMemo(() => [settings], [settings]);
  return (
    <>
      <Section id="Sky" title={t('Sky')} help={t('What is seen behind the objects, and lights them.')} icon="world">
        <FieldList owners={owners} names={sky} />
      </Section>
      <Section id="Fog" title={t('Fog')} help={t('How objects fade with distance.')} icon="world">
        <FieldList owners={owners} names={fog} />
      </Section>
      <Section id="Picture" title={t('Picture')} help={t('How light becomes a picture.')} icon="contrast">
        <FieldList owners={owners} names={picture} />
        <TechniqueLimit settings={settings} />
      </Section>
      <Section id="Shadows" title={t('Shadows')} help={t('How the shadows of all lights are drawn.')} icon="contrast">
        <FieldList owners={owners} names={shadows} />
      </Section>
      <Section
        id="Picture effects"
        title={t('Picture effects')}
        help={t('What is done to the finished picture.')}
        icon="contrast"
      >
        <FieldList owners={owners} names={effects} />
      </Section>
    </>
  );
}
