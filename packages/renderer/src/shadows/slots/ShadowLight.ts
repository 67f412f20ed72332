import type {
  DirectionalLight,
  LightShadow,
  OrthographicCamera,
  PerspectiveCamera,
  PointLight,
  SpotLight,
} from 'three';

/** Lights that three lets cast shadows. */
export type ShadowLight = (PointLight | SpotLight | DirectionalLight) & {
  isPointLight?: boolean;
  isSpotLight?: boolean;
};

/** The camera of a light's shadow, of either kind. */
export type ShadowCamera = PerspectiveCamera & OrthographicCamera;

/** three's LightShadow with what its types lack. */
export type PrivateLightShadow = LightShadow & { updateMatrices(light: ShadowLight): void };
