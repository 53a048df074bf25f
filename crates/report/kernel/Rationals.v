(* Over the rational numbers, without an axiom. *)
From Coq Require Import ZArith QArith Qabs List Lia Lqa Setoid.
From Boundfit Require Import Reader Checker Convex Sound.
Import ListNotations.
Local Open Scope Q_scope.

(* p is a mixture of three points of the list, which is enough in the plane. *)
Definition hull (points : list (Q * Q)) (p : Q * Q) :=
  exists a b c, In a points /\ In b points /\ In c points /\
  exists l m n, 0 <= l /\ 0 <= m /\ 0 <= n /\ l + m + n == 1 /\
  fst p == l * fst a + m * fst b + n * fst c /\ snd p == l * snd a + m * snd b + n * snd c.
(* p is a sum of multiples of three directions of the list. *)
Definition cone (rays : list (Q * Q)) (p : Q * Q) :=
  exists a b c, In a rays /\ In b rays /\ In c rays /\
  exists l m n, 0 <= l /\ 0 <= m /\ 0 <= n /\
  fst p == l * fst a + m * fst b + n * fst c /\ snd p == l * snd a + m * snd b + n * snd c.
Definition hull_and_cone (points rays : list (Q * Q)) (p : Q * Q) :=
  exists v r, hull points v /\ cone rays r /\ fst p == fst v + fst r /\ snd p == snd v + snd r.

(* The ends of the values that f takes on a set: bounds that are attained, or none. *)
Definition lowest (S : Q * Q -> Prop) (f : Q * Q -> Q) (b : Q) := (forall p, S p -> b <= f p) /\ (exists p, S p /\ f p == b).
Definition highest (S : Q * Q -> Prop) (f : Q * Q -> Q) (b : Q) := (forall p, S p -> f p <= b) /\ (exists p, S p /\ f p == b).
Definition no_lowest (S : Q * Q -> Prop) (f : Q * Q -> Q) := forall b, exists p, S p /\ f p < b.
Definition no_highest (S : Q * Q -> Prop) (f : Q * Q -> Q) := forall b, exists p, S p /\ b < f p.
Definition is_range S f low high := lowest S f low /\ highest S f high.

(* A row whose value lies between bounds, as far as there are any. *)
Definition at_least (low : option Q) (value : Q) := match low with Some b => b <= value | None => True end.
Definition at_most (value : Q) (high : option Q) := match high with Some b => value <= b | None => True end.

Definition nonnegative (a : Q) := 0 <= a.
Definition same (a : Q) := a.
Lemma rationals : ordered_field Q 0 1 Qplus Qmult Qminus Qopp Qeq nonnegative inject_Z same.
Proof.
  unfold nonnegative, same. constructor; intros; try reflexivity; try lra.
  - exact Q_Setoid.
  - constructor; repeat intro; [now rewrite H, H0 | now rewrite H, H0 | now rewrite H].
  - exact Qsrt.
  - now apply Qmult_le_0_compat.
  - rewrite inject_Z_plus. reflexivity.
  - change 0 with (inject_Z 0). rewrite <- Zle_Qle. exact H.
  - exists (/ inject_Z a). split.
    + apply Qinv_le_0_compat. change 0 with (inject_Z 0). rewrite <- Zle_Qle. lia.
    + apply Qmult_inv_r. intros E. unfold Qeq, inject_Z in E. cbn in E. lia.
  - unfold Qeq, Qmult, inject_Z. cbn [Qnum Qden]. rewrite Pos2Z.inj_mul. ring.
Qed.

Lemma nonnegative_difference a b : nonnegative (b - a) <-> a <= b.
Proof. unfold nonnegative. split; intros; lra. Qed.

(* Conditions and other rows with bounds of their own. *)
Definition keeps (c : form) (p : Q * Q) :=
  at_least (low c) (fst p * first c + snd p * second c) /\ at_most (fst p * first c + snd p * second c) (high c).
Definition meets_q := meets Q Qplus Qmult Qminus nonnegative same.
Definition feasible_q := feasible Q Qplus Qmult Qminus nonnegative same.

Lemma keeps_is c p : keeps c p <-> meets_q c p.
Proof.
  unfold keeps, meets_q, meets, at_least, at_most, le, value, same. split.
  - intros [L H]. split; intros b E; apply nonnegative_difference.
    + rewrite E in L. cbv beta iota in L. lra.
    + rewrite E in H. cbv beta iota in H. lra.
  - intros [L H]. split.
    + destruct (low c) as [b |]; [| exact I]. specialize (L b eq_refl). unfold nonnegative in L. cbn in *. lra.
    + destruct (high c) as [b |]; [| exact I]. specialize (H b eq_refl). unfold nonnegative in H. cbn in *. lra.
Qed.
Lemma within_is u v y e p : Qabs (y - (fst p * u + snd p * v)) <= e <-> meets_q (around u v y e) p.
Proof.
  unfold meets_q. rewrite (around_is _ _ _ _ _ _ _ _ _ _ _ rationals), Qabs_Qle_condition. unfold le, value, same.
  rewrite !nonnegative_difference. split; intros [L H]; split; lra.
Qed.
Lemma line_is x y e p : Qabs (y - (fst p * x + snd p)) <= e <-> meets_q (around x 1 y e) p.
Proof. rewrite <- within_is. setoid_replace (y - (fst p * x + snd p * 1)) with (y - (fst p * x + snd p)) by ring. reflexivity. Qed.

Lemma between_is u v lo hi p :
  at_least lo (fst p * u + snd p * v) /\ at_most (fst p * u + snd p * v) hi <-> meets_q (Form u v lo hi) p.
Proof. exact (keeps_is (Form u v lo hi) p). Qed.
Lemma line_between_is x lo hi p : at_least lo (fst p * x + snd p) /\ at_most (fst p * x + snd p) hi <-> meets_q (Form x 1 lo hi) p.
Proof.
  rewrite <- between_is. assert (E : fst p * x + snd p * 1 == fst p * x + snd p) by ring.
  unfold at_least, at_most. destruct lo, hi; rewrite ?E; reflexivity.
Qed.

Lemma at_most_is u v b p : fst p * u + snd p * v <= b <-> meets_q (Form u v None (Some b)) p.
Proof. rewrite <- between_is. unfold at_least, at_most. tauto. Qed.

(* The set of readings and conditions: [holds] is what a row says, [forms] what the checker is given. *)
Lemma together (row : Type) (rows : list row) (says : row -> Q * Q -> Prop) (of_row : row -> form) conditions p :
  (forall r, says r p <-> meets_q (of_row r) p) ->
  ((forall r, In r rows -> says r p) /\ (forall c, In c conditions -> keeps c p)) <-> feasible_q (map of_row rows ++ conditions) p.
Proof.
  intros H. unfold feasible_q, feasible. split.
  - intros [R C] c Hc. apply in_app_or in Hc. destruct Hc as [Hc | Hc].
    + apply in_map_iff in Hc. destruct Hc as (r & <- & Hr). apply H. auto.
    + apply keeps_is. auto.
  - intros F. split.
    + intros r Hr. apply H, F, in_or_app. left. now apply in_map.
    + intros c Hc. apply keeps_is, F, in_or_app. now right.
Qed.

Lemma alone (row : Type) (rows : list row) (says : row -> Q * Q -> Prop) (of_row : row -> form) p :
  (forall r, says r p <-> meets_q (of_row r) p) -> (forall r, In r rows -> says r p) <-> feasible_q (map of_row rows) p.
Proof.
  intros H. unfold feasible_q, feasible. split.
  - intros R c Hc. apply in_map_iff in Hc. destruct Hc as (r & <- & Hr). apply H. auto.
  - intros F r Hr. apply H, F. now apply in_map.
Qed.

Theorem bounded forms cert vs : check forms cert vs [] = true -> forall p, feasible_q forms p <-> hull vs p.
Proof. exact (bounded_sound _ _ _ _ _ _ _ _ _ _ _ rationals forms cert vs). Qed.
Theorem unbounded forms cert vs r rs : check forms cert vs (r :: rs) = true -> forall p, feasible_q forms p <-> hull_and_cone vs (r :: rs) p.
Proof. exact (unbounded_sound _ _ _ _ _ _ _ _ _ _ _ rationals forms cert vs r rs). Qed.
Theorem empty forms numbers : check_empty forms numbers = true -> forall p, ~ feasible_q forms p.
Proof. exact (empty_sound _ _ _ _ _ _ _ _ _ _ _ rationals forms numbers). Qed.

Lemma vertex_in_hull vs v : In v vs -> hull vs v.
Proof.
  intros H. exists v, v, v. do 3 (split; [assumption |]). exists 1, 0, 0.
  repeat split; try lra; unfold Qle; cbn; lia.
Qed.
Lemma zero_in_cone rs : rs <> [] -> cone rs (0, 0).
Proof.
  destruct rs as [| r rs]; [contradiction |]. intros _. exists r, r, r. do 3 (split; [now left |]). exists 0, 0, 0.
  repeat split; cbn; try lra; unfold Qle; cbn; lia.
Qed.

(* Ends, from the vertices and rays. *)
Section Ends.
  Variables (f : Q * Q -> Q) (a b : Q).
  Hypothesis linear : forall p, f p == a * fst p + b * snd p.
  Lemma hull_least vs m : (forall v, In v vs -> m <= f v) -> forall p, hull vs p -> m <= f p.
  Proof.
    intros H p (u & v & w & U & V & W & l & k & n & L & K & N & E & Ex & Ey).
    apply H in U, V, W. rewrite linear in *. rewrite Ex, Ey.
    assert (0 <= l * (a * fst u + b * snd u - m)) by (apply Qmult_le_0_compat; lra).
    assert (0 <= k * (a * fst v + b * snd v - m)) by (apply Qmult_le_0_compat; lra).
    assert (0 <= n * (a * fst w + b * snd w - m)) by (apply Qmult_le_0_compat; lra).
    assert (m == l * m + k * m + n * m) as -> by (setoid_replace (l * m + k * m + n * m) with ((l + k + n) * m) by ring; rewrite E; ring).
    lra.
  Qed.
  Lemma cone_least rs : (forall r, In r rs -> 0 <= f r) -> forall p, cone rs p -> 0 <= f p.
  Proof.
    intros H p (u & v & w & U & V & W & l & k & n & L & K & N & Ex & Ey).
    apply H in U, V, W. rewrite linear in *. rewrite Ex, Ey.
    assert (0 <= l * (a * fst u + b * snd u)) by (apply Qmult_le_0_compat; lra).
    assert (0 <= k * (a * fst v + b * snd v)) by (apply Qmult_le_0_compat; lra).
    assert (0 <= n * (a * fst w + b * snd w)) by (apply Qmult_le_0_compat; lra).
    lra.
  Qed.
End Ends.

Definition set_of (vs rs : list (Q * Q)) := match rs with [] => hull vs | _ => hull_and_cone vs rs end.
Definition check_lowest (f : Q * Q -> Q) vs rs m :=
  (forallb (fun v => Qle_bool m (f v)) vs && existsb (fun v => Qeq_bool (f v) m) vs && forallb (fun r => Qle_bool 0 (f r)) rs)%bool.
Definition check_highest (f : Q * Q -> Q) vs rs m :=
  (forallb (fun v => Qle_bool (f v) m) vs && existsb (fun v => Qeq_bool (f v) m) vs && forallb (fun r => Qle_bool (f r) 0) rs)%bool.
Definition check_no_lowest (f : Q * Q -> Q) (vs rs : list (Q * Q)) :=
  (match vs with [] => false | _ => true end && existsb (fun r => negb (Qle_bool 0 (f r))) rs)%bool.
Definition check_no_highest (f : Q * Q -> Q) (vs rs : list (Q * Q)) :=
  (match vs with [] => false | _ => true end && existsb (fun r => negb (Qle_bool (f r) 0)) rs)%bool.

Lemma vertex_in vs rs v : In v vs -> set_of vs rs v.
Proof.
  intros H. unfold set_of. destruct rs as [| r rs]; [now apply vertex_in_hull |].
  exists v, (0, 0). split; [now apply vertex_in_hull |]. split; [apply zero_in_cone; discriminate |]. cbn. split; ring.
Qed.
Lemma along_in vs rs v r t : In v vs -> In r rs -> 0 <= t -> set_of vs rs (fst v + t * fst r, snd v + t * snd r).
Proof.
  intros Hv Hr Ht. unfold set_of. destruct rs as [| r0 rs]; [destruct Hr |].
  exists v, (t * fst r, t * snd r). split; [now apply vertex_in_hull |]. cbn [fst snd]. split; [| split; ring].
  exists r, r, r. do 3 (split; [assumption |]). exists t, 0, 0. cbn [fst snd].
  repeat split; try assumption; try ring; unfold Qle; cbn; lia.
Qed.

Section Checks.
  Variables (f : Q * Q -> Q) (a b : Q).
  Hypothesis linear : forall p, f p == a * fst p + b * snd p.
  Lemma set_least vs rs m : (forall v, In v vs -> m <= f v) -> (forall r, In r rs -> 0 <= f r) -> forall p, set_of vs rs p -> m <= f p.
  Proof.
    intros Hv Hr p. unfold set_of. destruct rs as [| r0 rs]; [now apply hull_least with a b |].
    intros (v & r & Iv & Ir & Ex & Ey).
    apply (hull_least f a b linear vs m Hv) in Iv. apply (cone_least f a b linear (r0 :: rs) Hr) in Ir.
    rewrite linear in *. rewrite Ex, Ey. lra.
  Qed.
  Lemma lowest_sound vs rs m : check_lowest f vs rs m = true -> lowest (set_of vs rs) f m.
  Proof.
    unfold check_lowest. rewrite !Bool.andb_true_iff, !forallb_forall, existsb_exists. intros [[Hv (v & Iv & E)] Hr].
    split.
    - apply set_least; intros x Hx; apply Qle_bool_iff; auto.
    - exists v. split; [now apply vertex_in | now apply Qeq_bool_iff].
  Qed.
  Lemma no_highest_sound vs rs : check_no_highest f vs rs = true -> no_highest (set_of vs rs) f.
  Proof.
    unfold check_no_highest. rewrite Bool.andb_true_iff, existsb_exists. intros [Hv (r & Ir & E)] m.
    destruct vs as [| v vs]; [discriminate |].
    assert (0 < f r). { apply Qnot_le_lt. intros C. apply Qle_bool_iff in C. rewrite C in E. discriminate. }
    set (t := Qabs (m - f v + 1) / f r).
    exists (fst v + t * fst r, snd v + t * snd r).
    assert (T : t * f r == Qabs (m - f v + 1)) by (unfold t; field; lra).
    assert (0 <= t). { unfold t, Qdiv. apply Qmult_le_0_compat; [apply Qabs_nonneg | apply Qinv_le_0_compat; lra]. }
    split; [apply along_in; auto; now left |].
    assert (f (fst v + t * fst r, snd v + t * snd r) == f v + t * f r) as -> by (rewrite !linear; cbn [fst snd]; ring).
    rewrite T. pose proof (Qle_Qabs (m - f v + 1)). lra.
  Qed.
End Checks.
Section Mirror.
  Variables (f : Q * Q -> Q) (a b : Q).
  Hypothesis linear : forall p, f p == a * fst p + b * snd p.
  Let g p := - f p.
  Lemma mirrored p : g p == - a * fst p + - b * snd p.
  Proof. unfold g. rewrite linear. ring. Qed.
  Lemma highest_sound vs rs m : check_highest f vs rs m = true -> highest (set_of vs rs) f m.
  Proof.
    intros H. assert (L : lowest (set_of vs rs) g (- m)).
    { apply (lowest_sound g (- a) (- b) mirrored). unfold check_lowest, check_highest in *.
      rewrite !Bool.andb_true_iff, !forallb_forall, existsb_exists in *. destruct H as [[Hv (v & Iv & E)] Hr].
      repeat split.
      - intros x Hx. apply Hv in Hx. rewrite Qle_bool_iff in *. unfold g. lra.
      - exists v. split; [assumption |]. rewrite Qeq_bool_iff in *. unfold g. rewrite E. reflexivity.
      - intros x Hx. apply Hr in Hx. rewrite Qle_bool_iff in *. unfold g. lra. }
    destruct L as [L (p & Hp & E)]. unfold g in *. split.
    - intros p' Hp'. specialize (L p' Hp'). lra.
    - exists p. split; [assumption |]. lra.
  Qed.
  Lemma no_lowest_sound vs rs : check_no_lowest f vs rs = true -> no_lowest (set_of vs rs) f.
  Proof.
    intros H. assert (L : no_highest (set_of vs rs) g).
    { apply (no_highest_sound g (- a) (- b) mirrored). unfold check_no_lowest, check_no_highest in *.
      rewrite !Bool.andb_true_iff, existsb_exists in *. destruct H as [Hv (r & Ir & E)]. split; [assumption |].
      exists r. split; [assumption |]. destruct (Qle_bool (g r) 0) eqn:C; [| reflexivity].
      exfalso. apply Qle_bool_iff in C. unfold g in C.
      assert (D : Qle_bool 0 (f r) = true) by (apply Qle_bool_iff; lra). rewrite D in E. discriminate. }
    intros m. destruct (L (- m)) as (p & Hp & E). exists p. split; [assumption |]. unfold g in E. lra.
  Qed.
End Mirror.

(* What the theorem of a file needs. *)
Theorem set_sound forms cert vs rs : check forms cert vs rs = true -> forall p, feasible_q forms p <-> set_of vs rs p.
Proof. destruct rs; [apply bounded | apply unbounded]. Qed.
Lemma fst_is_linear p : fst p == 1 * fst p + 0 * snd p.
Proof. ring. Qed.
Lemma snd_is_linear p : snd p == 0 * fst p + 1 * snd p.
Proof. ring. Qed.
Section Transfer.
  Variables (f : Q * Q -> Q) (a b : Q) (linear : forall p, f p == a * fst p + b * snd p).
  Variables (S : Q * Q -> Prop) (vs rs : list (Q * Q)) (E : forall p, S p <-> set_of vs rs p).
  Lemma lowest_of m : check_lowest f vs rs m = true -> lowest S f m.
  Proof.
    intros H. apply (lowest_sound f a b linear) in H. destruct H as [L (p & Hp & A)].
    split; [intros x Hx; apply L, E, Hx | exists p; split; [apply E, Hp | exact A]].
  Qed.
  Lemma highest_of m : check_highest f vs rs m = true -> highest S f m.
  Proof.
    intros H. apply (highest_sound f a b linear) in H. destruct H as [L (p & Hp & A)].
    split; [intros x Hx; apply L, E, Hx | exists p; split; [apply E, Hp | exact A]].
  Qed.
  Lemma no_lowest_of : check_no_lowest f vs rs = true -> no_lowest S f.
  Proof. intros H m. apply (no_lowest_sound f a b linear) in H. destruct (H m) as (p & Hp & A). exists p. split; [apply E, Hp | exact A]. Qed.
  Lemma no_highest_of : check_no_highest f vs rs = true -> no_highest S f.
  Proof. intros H m. apply (no_highest_sound f a b linear) in H. destruct (H m) as (p & Hp & A). exists p. split; [apply E, Hp | exact A]. Qed.
End Transfer.

(* Linear programs: the ends of an objective a*theta1 + b*theta2 + c, and all points at which it has one value. *)
Lemma cost_is_linear a b p : fst p * a + snd p * b == a * fst p + b * snd p.
Proof. ring. Qed.
Lemma level_is forms a b c v p :
  feasible_q forms p /\ fst p * a + snd p * b + c == v <-> feasible_q (forms ++ [level a b c v]) p.
Proof.
  unfold feasible_q, feasible. split.
  - intros [F E] h H. apply in_app_or in H. destruct H as [H | [<- | []]]; [now apply F |].
    apply between_is. cbn. split; lra.
  - intros F. split; [intros h H; apply F, in_or_app; now left |].
    assert (L : meets_q (level a b c v) p) by (apply F, in_or_app; right; now left).
    apply between_is in L. cbn in L. lra.
Qed.
Theorem attained forms a b c v cert vs rs : check (forms ++ [level a b c v]) cert vs rs = true ->
  forall p, feasible_q forms p /\ fst p * a + snd p * b + c == v <-> set_of vs rs p.
Proof. intros H p. rewrite level_is. exact (set_sound _ cert vs rs H p). Qed.
Section Objective.
  Variables (a b c : Q) (S : Q * Q -> Prop) (vs rs : list (Q * Q)) (E : forall p, S p <-> set_of vs rs p).
  Let cost (p : Q * Q) := fst p * a + snd p * b.
  Theorem lowest_value v : check_lowest cost vs rs (v - c) = true -> lowest S (fun p => cost p + c) v.
  Proof.
    intros H. apply (lowest_of cost a b (cost_is_linear a b) S vs rs E) in H. destruct H as [L (p & Hp & A)].
    split; [intros q Hq; specialize (L q Hq); lra | exists p; split; [exact Hp | rewrite A; ring]].
  Qed.
  Theorem highest_value v : check_highest cost vs rs (v - c) = true -> highest S (fun p => cost p + c) v.
  Proof.
    intros H. apply (highest_of cost a b (cost_is_linear a b) S vs rs E) in H. destruct H as [L (p & Hp & A)].
    split; [intros q Hq; specialize (L q Hq); lra | exists p; split; [exact Hp | rewrite A; ring]].
  Qed.
  Theorem no_lowest_value : check_no_lowest cost vs rs = true -> no_lowest S (fun p => cost p + c).
  Proof.
    intros H m. apply (no_lowest_of cost a b (cost_is_linear a b) S vs rs E) in H.
    destruct (H (m - c)) as (p & Hp & A). exists p. split; [exact Hp | lra].
  Qed.
  Theorem no_highest_value : check_no_highest cost vs rs = true -> no_highest S (fun p => cost p + c).
  Proof.
    intros H m. apply (no_highest_of cost a b (cost_is_linear a b) S vs rs E) in H.
    destruct (H (m - c)) as (p & Hp & A). exists p. split; [exact Hp | lra].
  Qed.
End Objective.
