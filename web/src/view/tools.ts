import { texts } from "../texts";
import { byId, make } from "../ui/dom";
import { menuOf, oneOf, tick } from "../ui/menu";
import { OVERLAYS } from "./overlays/overlays";
import type { Watched } from "./overlays/watched";
import type { CameraName, View } from "./view";

const CAMERA_ICON = "M2.5 6.5h9v8h-9zM11.5 9.5l6-3v8l-6-3";
const SHOW_ICON = "M2 10s3-5 8-5 8 5 8 5-3 5-8 5-8-5-8-5zM10 12.2a2.2 2.2 0 1 0 0-4.4 2.2 2.2 0 0 0 0 4.4z";

/** Menus on the picture: the viewpoint, and the overlays. */
export class Tools {
  private readonly cameras = byId("cameras", HTMLDetailsElement);
  private offered = "";

  constructor(
    private readonly view: View,
    private readonly watched: Watched,
  ) {
    this.addCameras(["free"]);
    this.addShown();
    view.onLook((camera) => this.mark(camera));
  }

  /** Offers the viewpoints and overlays that are possible in the present run. */
  offer(): void {
    const cameras = this.view.cameras();
    if (cameras.join() !== this.offered) this.addCameras(cameras);
  }

  private addCameras(cameras: CameraName[]): void {
    const { picture } = texts;
    this.offered = cameras.join();
    const choices = cameras.map((name) => ({ name, label: picture.cameras[name] }));
    const { camera, mayDive } = this.view;
    menuOf(
      this.cameras,
      picture.camera,
      CAMERA_ICON,
      oneOf("camera", picture.camera, choices, camera, (name) => this.view.look(name)),
      tick("camera-dive", picture.dive, mayDive, (may) => this.view.dive(may)),
    );
  }

  private mark(camera: CameraName): void {
    const input = this.cameras.querySelector<HTMLInputElement>(`input[value="${camera}"]`);
    if (input) input.checked = true;
  }

  private addShown(): void {
    const { show, shown, shown_help } = texts.picture;
    const { view } = this;
    menuOf(
      byId("show", HTMLDetailsElement),
      show,
      SHOW_ICON,
      tick("frames", shown.frames, false, (isOn) => this.showFrames(isOn)),
      ...OVERLAYS.map((name) => tick(`show-${name}`, shown[name], false, (isOn) => this.watched.turn(name, isOn))),
      tick("show-plain", shown.plain, false, (isOn) => view.showPlain(isOn)),
      make("p", { class: "menu-note" }, shown_help),
    );
  }

  private showFrames(isShown: boolean): void {
    byId("frames-legend").hidden = !isShown;
    byId("scene-note").hidden = isShown;
    this.view.showFrames(isShown);
  }
}
