/** Whether a scene file, as text, has particles. */
export const needsParticles = (text: string): boolean => text.includes('"ParticleEmitter"');
